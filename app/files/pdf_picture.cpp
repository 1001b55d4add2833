#include "app/files/pdf_picture.h"

#include <QBuffer>
#include <QFontMetricsF>
#include <QPageLayout>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgRenderer>

namespace angiopose::app {
namespace {

constexpr double screenDotsPerInch = 96.0;
constexpr double pointsPerInch = 72.0;

/// Writes the text separately, since Qt draws SVG text as outlines; right-aligned text ends at its position.
void writeTexts(QPainter& painter, const ui::VectorImage& picture)
{
    QFont font;
    font.setFamilies({QStringLiteral("Inter"), QStringLiteral("Noto Sans CJK SC"), QStringLiteral("sans-serif")});
    for (const ui::VectorText& text : picture.texts) {
        font.setPixelSize(text.sizePx);
        painter.setFont(font);
        painter.setPen(QColor(QString::fromStdString(text.tone.hex())));
        const QString words = QString::fromStdString(text.text);
        const double width =
            text.align == ui::TextAlign::Right ? QFontMetricsF(font, painter.device()).horizontalAdvance(words) : 0.0;
        painter.drawText(QPointF(text.at.x() - width, text.at.y()), words);
    }
}

}   // namespace

QByteArray toPdf(const ui::VectorImage& picture, const SvgMetadata& metadata)
{
    ui::VectorImage withoutTexts = picture;
    withoutTexts.texts.clear();
    QSvgRenderer renderer(QByteArray::fromStdString(toSvgDocument(withoutTexts, metadata)));
    if (!renderer.isValid()) {
        return {};
    }
    const double dotsPerInch = metadata.dotsPerInch > 0.0 ? metadata.dotsPerInch : screenDotsPerInch;
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setTitle(QString::fromStdString(metadata.title));
    writer.setCreator(QStringLiteral("AngioPose ") + QStringLiteral(ANGIOPOSE_VERSION));
    QString provenance;
    for (const auto& [key, text] : metadata.texts) {
        provenance += QString::fromStdString(key + ": " + text + "\n");
    }
    writer.addFileAttachment(QStringLiteral("provenance.txt"), provenance.toUtf8(), QStringLiteral("text/plain"));
    writer.setPageSize(QPageSize(renderer.viewBoxF().size() * pointsPerInch / dotsPerInch, QPageSize::Point, {},
                                 QPageSize::ExactMatch));
    writer.setPageMargins(QMarginsF(0.0, 0.0, 0.0, 0.0));
    QPainter painter(&writer);
    renderer.render(&painter, QRectF(0.0, 0.0, writer.width(), writer.height()));
    painter.scale(1.0 * writer.width() / picture.width, 1.0 * writer.height() / picture.height);
    writeTexts(painter, picture);
    painter.end();
    return bytes;
}

}   // namespace angiopose::app

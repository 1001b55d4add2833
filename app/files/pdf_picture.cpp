#include "app/files/pdf_picture.h"

#include <QBuffer>
#include <QPageLayout>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgRenderer>

namespace angiopose::app {
namespace {

constexpr double screenDotsPerInch = 96.0;
constexpr double pointsPerInch = 72.0;

}   // namespace

QByteArray pdfOfSvg(const std::string& svg, const PdfFacts& facts)
{
    QSvgRenderer renderer(QByteArray::fromStdString(svg));
    if (!renderer.isValid()) {
        return {};
    }
    const double dotsPerInch = facts.dotsPerInch > 0.0 ? facts.dotsPerInch : screenDotsPerInch;
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setTitle(facts.title);
    writer.setCreator(QStringLiteral("AngioPose ") + QStringLiteral(ANGIOPOSE_VERSION));
    QString provenance;
    for (const auto& [key, text] : facts.texts) {
        provenance += QString::fromStdString(key + ": " + text + "\n");
    }
    writer.addFileAttachment(QStringLiteral("provenance.txt"), provenance.toUtf8(), QStringLiteral("text/plain"));
    writer.setPageSize(QPageSize(renderer.viewBoxF().size() * pointsPerInch / dotsPerInch, QPageSize::Point, {},
                                 QPageSize::ExactMatch));
    writer.setPageMargins(QMarginsF(0.0, 0.0, 0.0, 0.0));
    QPainter painter(&writer);
    renderer.render(&painter, QRectF(0.0, 0.0, writer.width(), writer.height()));
    painter.end();
    return bytes;
}

}   // namespace angiopose::app

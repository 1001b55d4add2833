#include "ui/views/shadowed_text.h"

#include <QCache>
#include <QImage>

#include <cmath>

namespace angiopose::ui {

QColor colorOf(const Color& color, double opacity)
{
    QColor result(color.red, color.green, color.blue);
    result.setAlphaF(static_cast<float>(opacity));
    return result;
}

const Palette& annotationTones()
{
    return palette(ThemeMode::Dark);
}

QFont withPixelSize(QFont font, int px)
{
    font.setPixelSize(px);
    return font;
}

namespace {

constexpr double rimPx = 1.0;
constexpr int maxCacheKiB = 2048;

void drawOutlined(QPainter& painter, const QRectF& box, int flags, const QString& text, const QColor& color,
                  const Color& rim)
{
    painter.setPen(colorOf(rim, 0.6));
    for (const double y : {-rimPx, 0.0, rimPx}) {   // an outline on all sides keeps the text readable
        for (const double x : {-rimPx, 0.0, rimPx}) {
            painter.drawText(box.translated(x, y), flags, text);
        }
    }
    painter.setPen(color);
    painter.drawText(box, flags, text);
}

QString cacheKey(const QFont& font, const QSizeF& size, double ratio, int flags, const QString& text,
                 const QColor& color, const Color& rim)
{
    return QStringLiteral("shadowed/%1/%2x%3/%4/%5/%6/%7/%8")
        .arg(font.key())
        .arg(size.width())
        .arg(size.height())
        .arg(ratio)
        .arg(flags)
        .arg(color.rgba())
        .arg(colorOf(rim).rgba())
        .arg(text);
}

/// Returns the text on a transparent image with margins for the outline. The image is cached: the text rarely changes,
/// and its layout and ten drawing passes cost more than all other annotations.
QImage outlinedText(const QFont& font, const QSizeF& size, double ratio, int flags, const QString& text,
                    const QColor& color, const Color& rim)
{
    static QCache<QString, QImage> cache(maxCacheKiB);
    const QString key = cacheKey(font, size, ratio, flags, text, color, rim);
    if (const QImage* words = cache.object(key)) {
        return *words;
    }
    const QSizeF whole = size + QSizeF(2.0 * rimPx, 2.0 * rimPx);
    QImage words((whole * ratio).toSize() + QSize(1, 1), QImage::Format_ARGB32_Premultiplied);
    words.setDevicePixelRatio(ratio);
    words.fill(Qt::transparent);
    QPainter painter(&words);
    painter.setFont(font);
    drawOutlined(painter, {QPointF(rimPx, rimPx), size}, flags, text, color, rim);
    painter.end();
    cache.insert(key, new QImage(words), static_cast<int>(words.sizeInBytes() / 1024) + 1);
    return words;
}

}   // namespace

void drawShadowedText(QPainter& painter, const QRectF& box, int flags, const QString& text, const QColor& color,
                      const Color& rim)
{
    if (painter.deviceTransform().type() > QTransform::TxTranslate && painter.device()->devicePixelRatio() == 1.0) {
        drawOutlined(painter, box, flags, text, color, rim);
        return;
    }
    const double ratio = painter.device()->devicePixelRatio();
    const auto onPixel = [ratio](double at) { return std::round((at - rimPx) * ratio) / ratio; };
    painter.drawImage(QPointF(onPixel(box.left()), onPixel(box.top())),
                      outlinedText(painter.font(), box.size(), ratio, flags, text, color, rim));
}

}   // namespace angiopose::ui

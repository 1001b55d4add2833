#include "ui/views/shadowed_text.h"

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

QFont sized(QFont font, int px)
{
    font.setPixelSize(px);
    return font;
}

void drawShadowedText(QPainter& painter, const QRectF& box, int flags, const QString& text, const QColor& color,
                      const Color& rim)
{
    painter.setPen(colorOf(rim, 0.6));
    for (const double y : {-1.0, 0.0, 1.0}) {   // a rim all round: readable on any picture, without a box
        for (const double x : {-1.0, 0.0, 1.0}) {
            painter.drawText(box.translated(x, y), flags, text);
        }
    }
    painter.setPen(color);
    painter.drawText(box, flags, text);
}

}   // namespace angiopose::ui
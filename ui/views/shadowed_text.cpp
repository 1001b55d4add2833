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

void drawShadowedText(QPainter& painter, const QRectF& box, int flags, const QString& text, const QColor& color)
{
    painter.setPen(colorOf(annotationTones().canvas, 0.75));
    for (const QPointF& offset : {QPointF(1.0, 1.0), QPointF(-1.0, 0.0), QPointF(0.0, -1.0)}) {
        painter.drawText(box.translated(offset), flags, text);
    }
    painter.setPen(color);
    painter.drawText(box, flags, text);
}

}   // namespace angiopose::ui
#include "ui/views/pivot_mark.h"

#include "ui/theme/active_theme.h"

#include <QCoreApplication>
#include <QPainter>

namespace angiopose::ui {

void paintPivotMark(QPainter& painter, const QPointF& at, const Palette& colors)
{
    constexpr double ringPx = 6.0, dotPx = 1.8;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(toQColor(colors.panel), 4.0));
    painter.drawEllipse(at, ringPx, ringPx);
    painter.setPen(QPen(toQColor(colors.attention), 1.8));
    painter.drawEllipse(at, ringPx, ringPx);
    painter.setPen(Qt::NoPen);
    painter.setBrush(toQColor(colors.attention));
    painter.drawEllipse(at, dotPx, dotPx);
    QFont small = painter.font();
    small.setPixelSize(11);
    painter.setFont(small);
    const QString word = QCoreApplication::translate("angiopose::ui::PivotMark", "rotation center");
    const QPointF textPosition = at + QPointF(ringPx + 4.0, -ringPx);
    painter.setPen(toQColor(colors.panel));
    painter.drawText(textPosition + QPointF(1.0, 1.0), word);
    painter.setPen(toQColor(colors.attention));
    painter.drawText(textPosition, word);
    painter.restore();
}

}   // namespace angiopose::ui

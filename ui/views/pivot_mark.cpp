#include "ui/views/pivot_mark.h"

#include "ui/theme/active_theme.h"

#include <QCoreApplication>
#include <QPainter>

namespace angiopose::ui {

void paintPivotMark(QPainter& painter, const QPointF& at, const Palette& tones)
{
    constexpr double ringPx = 6.0, dotPx = 1.8;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(toQColor(tones.panel), 4.0));
    painter.drawEllipse(at, ringPx, ringPx);
    painter.setPen(QPen(toQColor(tones.attention), 1.8));
    painter.drawEllipse(at, ringPx, ringPx);
    painter.setPen(Qt::NoPen);
    painter.setBrush(toQColor(tones.attention));
    painter.drawEllipse(at, dotPx, dotPx);
    QFont small = painter.font();
    small.setPixelSize(11);
    painter.setFont(small);
    const QString word = QCoreApplication::translate("angiopose::ui::PivotMark", "pivot");
    const QPointF place = at + QPointF(ringPx + 4.0, -ringPx);
    painter.setPen(toQColor(tones.panel));
    painter.drawText(place + QPointF(1.0, 1.0), word);
    painter.setPen(toQColor(tones.attention));
    painter.drawText(place, word);
    painter.restore();
}

}   // namespace angiopose::ui

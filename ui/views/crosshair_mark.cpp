#include "ui/views/crosshair_mark.h"

#include "ui/theme/active_theme.h"

#include <QPainter>

namespace angiopose::ui {
namespace {

void strokeCross(QPainter& painter, const QPointF& at, const QPen& pen)
{
    constexpr double nearPx = 4.0;
    constexpr double farPx = 11.0;
    painter.setPen(pen);
    for (const QPointF& direction : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
        painter.drawLine(at + nearPx * direction, at + farPx * direction);
    }
}

}   // namespace

void paintCrosshairMark(QPainter& painter, const QPointF& at, const Palette& colors)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    strokeCross(painter, at, QPen(toQColor(colors.panel, 0.8), 4.0));
    strokeCross(painter, at, QPen(toQColor(colors.accent), 1.6));
    painter.restore();
}

void paintEpipolarLine(QPainter& painter, const QLineF& line, const Palette& colors)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(toQColor(colors.canvas, 0.6), 3.0));
    painter.drawLine(line);
    QPen dashes(toQColor(colors.accent), 1.2);
    dashes.setDashPattern({7.0, 5.0});
    painter.setPen(dashes);
    painter.drawLine(line);
    painter.restore();
}

}   // namespace angiopose::ui

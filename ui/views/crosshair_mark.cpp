#include "ui/views/crosshair_mark.h"

#include "ui/theme/active_theme.h"

#include <QPainter>

#include <array>

namespace angiopose::ui {
namespace {

void strokeCross(QPainter& painter, const QPointF& at, const QPen& pen)
{
    constexpr double nearPx = 4.0;
    constexpr double farPx = 11.0;
    painter.setPen(pen);
    for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
        painter.drawLine(at + nearPx * way, at + farPx * way);
    }
}

}   // namespace

void paintPlaceMark(QPainter& painter, const QPointF& at, const Palette& tones)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    strokeCross(painter, at, QPen(toQColor(tones.panel, 0.8), 4.0));
    strokeCross(painter, at, QPen(toQColor(tones.accent), 1.6));
    painter.restore();
}

void paintEpipolarLine(QPainter& painter, const QLineF& line, const Palette& tones)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(toQColor(tones.canvas, 0.6), 3.0));
    painter.drawLine(line);
    QPen dashes(toQColor(tones.accent), 1.2);
    dashes.setDashPattern({7.0, 5.0});
    painter.setPen(dashes);
    painter.drawLine(line);
    painter.restore();
}

}   // namespace angiopose::ui

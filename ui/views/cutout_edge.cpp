#include "ui/views/cutout_edge.h"

#include "ui/theme/active_theme.h"

#include <QPainter>

namespace angiopose::ui {

QPainterPath cutoutPath(const Cutout& cutout, const ImageViewport& viewport, const QSizeF& size)
{
    QPainterPath path;
    const Eigen::Vector2d at = viewport.widgetFromImage(cutout.at);
    const double width = size.width();
    constexpr double outside = 4.0;   // the edges of the widget are none of the swipe
    const double height = size.height() + 2.0 * outside;
    if (cutout.shape == Cutout::Shape::Disc) {
        const double radius = cutout.radiusPx * viewport.zoom();
        path.addEllipse(QPointF(at.x(), at.y()), radius, radius);
    } else if (cutout.shape == Cutout::Shape::RightOf && viewport.isMirrored()) {
        path.addRect(QRectF(-outside, -outside, at.x() + outside, height));
    } else if (cutout.shape == Cutout::Shape::RightOf) {
        path.addRect(QRectF(at.x(), -outside, width - at.x() + outside, height));
    }
    return path;
}

void paintCutoutEdge(QPainter& painter, const QPainterPath& path)
{
    const Palette& tones = palette(ThemeMode::Dark);   // the angiogram lies on black in every theme
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(toQColor(tones.canvas, 0.6), 3.0));
    painter.drawPath(path);
    painter.setPen(QPen(toQColor(tones.textStrong, 0.8), 1.2));
    painter.drawPath(path);
}

}   // namespace angiopose::ui
#pragma once

#include "ui/scenes/overlay_scene.h"
#include "ui/views/image_viewport.h"

#include <QRectF>
#include <QStringList>

#include <algorithm>
#include <array>
#include <vector>

class QPainter;

namespace angiopose::ui {

enum class Corner { TopLeft, TopRight, BottomLeft, BottomRight };

/// Determines what a part of the widget contains: vessels, image or other items.
class ViewContent {
public:
    /// `occupied` holds the areas of other items over the image, in widget px.
    ViewContent(const ImageViewport& viewport, const OverlayScene& scene, const std::vector<QRectF>& occupied)
        : viewport_(viewport), scene_(scene), occupied_(occupied)
    {
    }

    bool isTaken(const QRectF& part) const
    {
        return std::ranges::any_of(occupied_,
                                   [&part](const QRectF& occupiedRect) { return occupiedRect.intersects(part); });
    }

    bool hasVessels(const QRectF& part) const
    {
        const QRectF wide = part.adjusted(-4.0, -4.0, 4.0, 4.0);
        return scene_.treeIntersects(viewport_.imageRectOf({wide.left(), wide.top()}, {wide.right(), wide.bottom()}));
    }

    bool hasImage(const QRectF& part) const
    {
        const core::ImageF& frame = scene_.frame();
        const Eigen::Vector2d topLeft = viewport_.widgetFromImage({-0.5, -0.5});
        const Eigen::Vector2d bottomRight = viewport_.widgetFromImage({frame.width - 0.5, frame.height - 0.5});
        return part.intersects(
            QRectF(QPointF(topLeft.x(), topLeft.y()), QPointF(bottomRight.x(), bottomRight.y())).normalized());
    }

private:
    const ImageViewport& viewport_;
    const OverlayScene& scene_;
    const std::vector<QRectF>& occupied_;
};

using CornerLines = std::array<QStringList, 4>;   ///< indexed by `Corner`

/// Draws a block of lines in every corner, all in one font size, and returns the areas covered; `mode` is the area of
/// the mode label at the top. If a block would cover vessels, the image or other items, all blocks shrink; a block that
/// still does not fit collapses to one line or is omitted.
std::array<QRectF, 4> paintCorners(QPainter& painter, const QSizeF& size, const CornerLines& lines,
                                   const ViewContent& content, const QRectF& mode = {});

}   // namespace angiopose::ui

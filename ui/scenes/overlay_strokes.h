#pragma once

#include "ui/scenes/overlay_content.h"
#include "ui/scenes/stroke_mesh.h"

namespace angiopose::ui {

/// Maps image pixels (v down) to device pixels (y up) of a view that shows `rect`.
struct DeviceFromImage {
    ViewRect rect;
    int width = 1;
    int height = 1;

    Eigen::Vector2d operator*(const Eigen::Vector2d& imagePoint) const;
    double scale() const { return width / (rect.right - rect.left); }   ///< device px per image px
};

/// Returns the triangles of the whole overlay, in drawing order.
StrokeMesh overlayStrokes(const OverlayContent& content, const DeviceFromImage& deviceFromImage);

/// Returns the whole overlay as vector shapes, in drawing order.
std::vector<StrokeShape> overlayShapes(const OverlayContent& content, const DeviceFromImage& deviceFromImage);

}   // namespace angiopose::ui

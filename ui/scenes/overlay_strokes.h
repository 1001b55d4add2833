#pragma once

#include "ui/scenes/overlay_content.h"
#include "ui/scenes/stroke_mesh.h"

namespace angiopose::ui {

/// From image pixels (v down) to device pixels of a picture (y up) that shows `rect`.
struct DeviceFromImage {
    ViewRect rect;
    int width = 1;
    int height = 1;

    Eigen::Vector2d operator*(const Eigen::Vector2d& imagePoint) const;
    double scale() const { return width / (rect.right - rect.left); }   ///< device px per image px
};

/// Lines of the whole overlay, lowest first.
StrokeMesh overlayStrokes(const OverlayContent& content, const DeviceFromImage& deviceFromImage);

/// The same as shapes.
std::vector<StrokeShape> overlayShapes(const OverlayContent& content, const DeviceFromImage& deviceFromImage);

}   // namespace angiopose::ui
#pragma once

#include "ui/scenes/overlay_scene.h"
#include "ui/scenes/projected_tree.h"
#include "ui/scenes/stroke_mesh.h"

#include <map>
#include <vector>

namespace angiopose::ui {

/// From image pixels (v down) to device pixels of a picture (y up) that shows `rect`.
struct DeviceFromImage {
    ViewRect rect;
    int width = 1;
    int height = 1;

    Eigen::Vector2d operator*(const Eigen::Vector2d& imagePoint) const;
    double scale() const { return width / (rect.right - rect.left); }   ///< device px per image px
};

/// Nearest and farthest point of a projected tree.
struct DepthRange {
    double nearMm = 0.0;
    double farMm = 0.0;
};
DepthRange depthRangeOf(const ProjectedTree& tree);

/// What lies on the angiogram and how it looks.
struct OverlayContent {
    ProjectedTree tree;
    BranchMarks marks;
    OverlayMode mode = OverlayMode::Centerline;
    bool isVeiled = false;
    DepthCue depthCue = DepthCue::None;
    DepthRange depthRange;   ///< of `tree`
    double opacity = 1.0;
    double lineWidthPx = 2.0;
    core::Centerline2d traced;
    bool isTracedShown = false;
    std::map<int, std::vector<double>> residualPx;
    double scaleMaximumPx = 0.0;   ///< 0: branches in their own colours
};

/// Lines of the whole overlay, lowest first.
StrokeMesh overlayStrokes(const OverlayContent& content, const DeviceFromImage& deviceFromImage);

}   // namespace angiopose::ui
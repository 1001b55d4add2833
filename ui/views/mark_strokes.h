#pragma once

#include "ui/scenes/image_mark.h"
#include "ui/scenes/stroke_mesh.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::ui {

/// Image onto which mark lines are drawn, in device px, y up.
struct MarkCanvas {
    Eigen::Vector2d sizePx = Eigen::Vector2d::Zero();
    double pixelRatio = 1.0;   ///< device px per px at 100 % scale
};

/// Returns the lines of marks as strokes with a colored outline; `positionOf` returns px at 100 % scale, y down. For
/// crossing lines, QPainter would take ten times as long.
StrokeMesh markStrokes(const std::vector<ImageMark>& marks, const PixelMapping& positionOf, const MarkCanvas& image,
                       const Palette& colors, const Color& rim);

}   // namespace angiopose::ui

#pragma once

#include "ui/scenes/image_mark.h"
#include "ui/scenes/stroke_mesh.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::ui {

/// What the lines of marks are drawn on: a picture in device px, y up.
struct MarkPicture {
    Eigen::Vector2d sizePx = Eigen::Vector2d::Zero();
    double pixelRatio = 1.0;   ///< device px per px at 100 %
};

/// The lines of marks as strokes, with a rim of its own colour; `placeOf` gives px at 100 %, v down. QPainter's pens
/// take ten times as long where lines cross each other.
StrokeMesh markStrokes(const std::vector<ImageMark>& marks, const MarkPlace& placeOf, const MarkPicture& picture,
                       const Palette& tones, const Color& rim);

}   // namespace angiopose::ui

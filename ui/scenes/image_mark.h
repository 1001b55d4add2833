#pragma once

#include "ui/theme/theme.h"

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace angiopose::ui {

enum class MarkShape {
    Length,   ///< polyline with a bar across each end
    Angle,   ///< two legs and an arc at the second point
    Outline,   ///< closed polyline
    Line,   ///< polyline
    Point,   ///< circle around each point
    Cross,   ///< cross at each point
    Arrow,   ///< arrow to its last point
    Words,   ///< only the label, at the first point
};

/// Plain for manual measurements and drawings, Place for locations on the vessels.
enum class MarkTone { Plain, Place };

/// Shape drawn on an image with a label beside it.
struct ImageMark {
    MarkShape shape = MarkShape::Length;
    std::vector<Eigen::Vector2d> pixels;   ///< points in image px
    std::string label;   ///< UTF-8; may be empty
    bool isChosen = false;   ///< highlighted
    MarkTone tone = MarkTone::Plain;
};

using PixelLine = std::vector<Eigen::Vector2d>;

/// Maps image pixels to drawing positions, v down.
using MarkPlace = std::function<Eigen::Vector2d(const Eigen::Vector2d& pixel)>;

/// Returns the lines that draw a mark; `sizePx` is the size of its small parts in the drawing.
std::vector<PixelLine> linesOf(const ImageMark& mark, const MarkPlace& placeOf, double sizePx);

/// Returns points along the lines of marks that labels avoid.
std::vector<Eigen::Vector2d> pointsAlong(const std::vector<PixelLine>& lines, double stepPx);

/// Anchor of the label: the last point, for an angle the vertex, for an arrow its tail.
Eigen::Vector2d labelAnchor(const ImageMark& mark, const MarkPlace& placeOf);

/// Returns the color of a mark from the tones of its background.
Color toneOf(const ImageMark& mark, const Palette& tones);

}   // namespace angiopose::ui

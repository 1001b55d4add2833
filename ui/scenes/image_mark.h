#pragma once

#include "ui/theme/theme.h"

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace angiopose::ui {

enum class MarkShape {
    Length,   ///< along its points, with a bar across each end
    Angle,   ///< two legs and an arc at the second point
    Outline,   ///< closed
    Line,   ///< along its points
    Point,   ///< a circle around each point
    Cross,   ///< two strokes through each point
    Arrow,   ///< to its last point
    Words,   ///< the label alone, at the first point
};

/// Measured and drawn by hand, or a place of the vessels.
enum class MarkTone { Plain, Place };

/// Something drawn on an image with words beside it.
struct ImageMark {
    MarkShape shape = MarkShape::Length;
    std::vector<Eigen::Vector2d> pixels;   ///< of the image
    std::string label;   ///< UTF-8; may be empty
    bool isChosen = false;   ///< stands out
    MarkTone tone = MarkTone::Plain;
};

using PixelLine = std::vector<Eigen::Vector2d>;

/// From pixels of the image to where they are drawn, v down.
using MarkPlace = std::function<Eigen::Vector2d(const Eigen::Vector2d& pixel)>;

/// The lines that draw a mark; `sizePx` of the picture is the length of its small parts.
std::vector<PixelLine> linesOf(const ImageMark& mark, const MarkPlace& placeOf, double sizePx);

/// Points along the lines of marks, for labels to keep clear of them.
std::vector<Eigen::Vector2d> pointsAlong(const std::vector<PixelLine>& lines, double stepPx);

/// What its label stands beside: the last point, of an angle the vertex, of an arrow its tail.
Eigen::Vector2d labelAnchor(const ImageMark& mark, const MarkPlace& placeOf);

/// Its colour, of the tones of what it lies on.
Color toneOf(const ImageMark& mark, const Palette& tones);

}   // namespace angiopose::ui

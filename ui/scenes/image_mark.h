#pragma once

#include "ui/theme/theme.h"

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace angiopose::ui {

enum class MarkShape {
    Length,   ///< polyline with a bar across each end
    Angle,   ///< two legs with an arc at their vertex, which is the second point
    Outline,   ///< closed polyline
    Line,   ///< open polyline
    Point,   ///< circle around each point
    Cross,   ///< cross at each point
    Arrow,   ///< arrow with its tip at the last point
    Text,   ///< label only, at the first point
};

/// Plain is for manual measurements and drawings, Place for locations on the vessels.
enum class MarkTone { Plain, Place };

/// Shape drawn on an image, with a label next to it.
struct ImageMark {
    MarkShape shape = MarkShape::Length;
    std::vector<Eigen::Vector2d> pixels;   ///< points in image px
    std::string label;   ///< UTF-8; may be empty
    bool isSelected = false;   ///< true if selected and therefore highlighted
    MarkTone tone = MarkTone::Plain;
};

using PixelLine = std::vector<Eigen::Vector2d>;

/// Maps image pixels to positions in the drawing, y down.
using PixelMapping = std::function<Eigen::Vector2d(const Eigen::Vector2d& pixel)>;

/// Returns the lines that draw a mark; `sizePx` is the size of bars, circles, crosses and arrowheads in the drawing.
std::vector<PixelLine> markLines(const ImageMark& mark, const PixelMapping& positionOf, double sizePx);

/// Samples lines at intervals of `stepPx`; labels avoid the resulting points.
std::vector<Eigen::Vector2d> pointsAlong(const std::vector<PixelLine>& lines, double stepPx);

/// Returns the anchor point of the label: the vertex of an angle, the tail of an arrow, otherwise the last point.
Eigen::Vector2d labelAnchor(const ImageMark& mark, const PixelMapping& positionOf);

/// Returns the color of a mark on a background whose palette is `colors`.
Color markColor(const ImageMark& mark, const Palette& colors);

}   // namespace angiopose::ui

#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace angiopose::ui {

enum class MarkShape {
    Length,   ///< along its points, with a bar across each end
    Angle,   ///< two legs and an arc at the second point
    Outline,   ///< closed
};

/// Something drawn on an image with words beside it.
struct ImageMark {
    MarkShape shape = MarkShape::Length;
    std::vector<Eigen::Vector2d> pixels;   ///< of the image
    std::string label;   ///< UTF-8; may be empty
    bool isChosen = false;   ///< stands out
};

using PixelLine = std::vector<Eigen::Vector2d>;

/// From pixels of the image to where they are drawn, v down.
using MarkPlace = std::function<Eigen::Vector2d(const Eigen::Vector2d& pixel)>;

/// The lines that draw a mark; `sizePx` of the picture is the length of its small parts.
std::vector<PixelLine> linesOf(const ImageMark& mark, const MarkPlace& placeOf, double sizePx);

/// Where its label begins: at the last point, of an angle at the vertex.
Eigen::Vector2d labelPlace(const ImageMark& mark, const MarkPlace& placeOf, double sizePx);

}   // namespace angiopose::ui

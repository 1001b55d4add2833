#pragma once

#include "core/imaging/image2d.h"
#include "ui/scenes/render_offscreen.h"
#include "ui/scenes/vector_picture.h"

namespace angiopose::ui {

/// Size of everything that is burned into a picture, in px.
struct BurnSizes {
    int textPx = 14;
    int marginPx = 14;
};

/// Sizes in proportion to the picture, readable when it is printed.
BurnSizes burnSizes(int width, int height);

void burnTexts(core::ColorImage& picture, const CornerTexts& texts, const BurnSizes& sizes);
void burnTexts(VectorPicture& picture, const CornerTexts& texts, const BurnSizes& sizes);

/// One line with its upper left corner at a place, moved as far as it takes to stay in the picture.
void burnLabel(core::ColorImage& picture, const std::string& text, const Eigen::Vector2d& at, const BurnSizes& sizes);
void burnLabel(VectorPicture& picture, const std::string& text, const Eigen::Vector2d& at, const BurnSizes& sizes);

/// A line that nobody overlooks, in the tone of attention: at the top, in the middle.
void burnVerdict(core::ColorImage& picture, const std::string& text, const BurnSizes& sizes);
void burnVerdict(VectorPicture& picture, const std::string& text, const BurnSizes& sizes);

/// How much of a picture such a line takes, px; zero where there is none.
Eigen::Vector2d burnedSize(const std::string& text, const BurnSizes& sizes);

/// Where the ramp of colours ends.
struct BurnScale {
    double maximumPx = 0.0;
    double maximumMm = 0.0;   ///< 0: labelled in px
    char decimalSign = '.';
    std::string heading = {};   ///< empty: the unit
};

/// The ramp with its end values at the right edge.
void burnScale(core::ColorImage& picture, const BurnScale& scale, const BurnSizes& sizes);
void burnScale(VectorPicture& picture, const BurnScale& scale, const BurnSizes& sizes);

}   // namespace angiopose::ui
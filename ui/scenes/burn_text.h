#pragma once

#include "core/imaging/image2d.h"
#include "ui/scenes/render_offscreen.h"
#include "ui/scenes/vector_image.h"

namespace angiopose::ui {

/// Sizes of text and margins burned into an exported image.
struct BurnSizes {
    int textPx = 14;
    int marginPx = 14;
};

/// Returns sizes in proportion to the image, readable when printed.
BurnSizes burnSizes(int width, int height);

void burnTexts(core::ColorImage& image, const CornerTexts& texts, const BurnSizes& sizes);
void burnTexts(VectorImage& image, const CornerTexts& texts, const BurnSizes& sizes);

/// Draws one line of text with its upper left corner at `at`, shifted if necessary to stay inside the image.
void burnLabel(core::ColorImage& image, const std::string& text, const Eigen::Vector2d& at, const BurnSizes& sizes);
void burnLabel(VectorImage& image, const std::string& text, const Eigen::Vector2d& at, const BurnSizes& sizes);

/// Draws the verdict as a prominent line in the attention color, centered at the top.
void burnVerdict(core::ColorImage& image, const std::string& text, const BurnSizes& sizes);
void burnVerdict(VectorImage& image, const std::string& text, const BurnSizes& sizes);

/// Returns the size in px of a burned-in line of text; zero if there is no text.
Eigen::Vector2d burnedSize(const std::string& text, const BurnSizes& sizes);

/// Maximum and heading of the color ramp.
struct BurnScale {
    double maximumPx = 0.0;
    double maximumMm = 0.0;   ///< maximum; if 0, the labels are in px
    char decimalSign = '.';
    std::string heading = {};   ///< if empty, only the unit is shown
};

/// Draws the color ramp, with its ends labeled, at the right edge.
void burnScale(core::ColorImage& image, const BurnScale& scale, const BurnSizes& sizes);
void burnScale(VectorImage& image, const BurnScale& scale, const BurnSizes& sizes);

}   // namespace angiopose::ui

#pragma once

#include "ui/scenes/vector_image.h"

#include <map>
#include <string>

namespace angiopose::app {

/// Metadata of an SVG file.
struct SvgMetadata {
    std::string title;
    std::map<std::string, std::string> texts;   ///< provenance, the same as in the text chunks of a PNG
    double dotsPerInch = 0.0;   ///< if 0, sizes are in screen px
};

/// Converts the image to SVG 1.1, using only features of SVG Tiny 1.2: lines as paths, text as text, pixels as an
/// embedded PNG.
std::string toSvgDocument(const ui::VectorImage& picture, const SvgMetadata& metadata);

}   // namespace angiopose::app

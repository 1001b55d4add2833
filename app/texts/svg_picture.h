#pragma once

#include "ui/scenes/vector_picture.h"

#include <map>
#include <string>

namespace angiopose::app {

/// Metadata of an SVG file.
struct SvgFacts {
    std::string title;
    std::map<std::string, std::string> texts;   ///< provenance, the same as in the text chunks of a PNG
    double dotsPerInch = 0.0;   ///< if 0, sizes are in screen px
};

/// Converts the image to SVG 1.1, using only features of SVG Tiny 1.2: lines as paths, texts as text, pixels as an
/// embedded PNG.
std::string svgOf(const ui::VectorPicture& picture, const SvgFacts& facts);

}   // namespace angiopose::app

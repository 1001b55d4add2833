#pragma once

#include "ui/scenes/vector_picture.h"

#include <map>
#include <string>

namespace angiopose::app {

/// What an SVG file says about itself.
struct SvgFacts {
    std::string title;
    std::map<std::string, std::string> texts;   ///< provenance, as the text chunks of a PNG
    double dotsPerInch = 0.0;   ///< 0: px of the screen
};

/// The picture as SVG 1.1, of parts that SVG Tiny 1.2 has, too: lines as paths, texts as text, pixels as embedded PNG.
std::string svgOf(const ui::VectorPicture& picture, const SvgFacts& facts);

}   // namespace angiopose::app

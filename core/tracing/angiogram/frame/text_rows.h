#pragma once

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Bounds of one connected shape, px, all inside it.
struct Glyph {
    int left, right, top, bottom;
    int height() const { return bottom - top + 1; }
    int width() const { return right - left + 1; }
};

/// Of the shape with these pixels, as `componentsOf` gives them.
Glyph boundsOf(const std::vector<std::size_t>& pixels, int imageWidth);

/// Rows of three or more shapes side by side: of about one height, on one level, not farther apart than two letters.
std::vector<std::vector<Glyph>> textRows(std::vector<Glyph> glyphs);

}   // namespace angiopose::core

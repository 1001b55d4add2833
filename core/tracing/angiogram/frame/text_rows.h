#pragma once

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Bounds of one connected shape, px, inclusive.
struct Glyph {
    int left, right, top, bottom;
    int height() const { return bottom - top + 1; }
    int width() const { return right - left + 1; }
};

/// Returns the bounds of the shape with these pixels, as returned by `componentsOf`.
Glyph boundsOf(const std::vector<std::size_t>& pixels, int imageWidth);

/// Groups shapes into rows of three or more with similar height, the same baseline and gaps of at most two letters.
std::vector<std::vector<Glyph>> findTextRows(std::vector<Glyph> glyphs);

}   // namespace angiopose::core

#pragma once

#include "core/imaging/image2d.h"

#include <cstdint>
#include <vector>

namespace angiopose::io {

/// A picture as video codecs take it: brightness and, at half the resolution, two colour differences; ITU-R BT.709, the
/// narrow range (16…235), colours where the left of two columns is.
struct PlanarPicture {
    int width = 0;   ///< even
    int height = 0;   ///< even
    std::vector<std::uint8_t> luma;
    std::vector<std::uint8_t> blue;   ///< Cb
    std::vector<std::uint8_t> red;   ///< Cr
};

/// Where a side is odd, its last column or row is there twice.
PlanarPicture planarPicture(const core::ColorImage& picture);

}   // namespace angiopose::io

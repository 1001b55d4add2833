#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace angiopose::io {

using RgbColor = std::array<std::uint8_t, 3>;   ///< sRGB

/// A color in the DICOM representation: CIELab under D50, scaled to 16 bits (PS3.3 C.10.7.1.1).
std::vector<std::uint16_t> labColor(const RgbColor& color);

}   // namespace angiopose::io

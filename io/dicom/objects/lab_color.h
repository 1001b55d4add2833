#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace angiopose::io {

using RgbColor = std::array<std::uint8_t, 3>;   ///< color in sRGB, 0…255

/// Converts a color to the DICOM representation: CIELab with D50 white point, scaled to 16 bits (PS3.3 C.10.7.1.1).
std::vector<std::uint16_t> labColor(const RgbColor& color);

}   // namespace angiopose::io

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace angiopose::io {

/// Pixels of a PNG, row-major: one sample (gray) or three (sRGB), of one byte or two big-endian bytes each.
struct PngPixels {
    int width = 0;
    int height = 0;
    int channels = 3;
    const std::vector<std::uint8_t>* bytes = nullptr;
    int bitDepth = 8;   ///< 8 or 16
    double dotsPerInch = 0.0;   ///< print resolution; 0 if not specified
};

/// Encodes a PNG through libpng, with `texts` as iTXt chunks (UTF-8). Throws if libpng rejects the image (too many
/// columns).
std::string encodePng(const PngPixels& pixels, const std::map<std::string, std::string>& texts);

}   // namespace angiopose::io

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace angiopose::io {

/// Pixels of an 8-bit PNG: one byte (grey) or three (sRGB) per pixel, row-major.
struct PngPixels {
    int width = 0;
    int height = 0;
    int channels = 3;
    const std::vector<std::uint8_t>* bytes = nullptr;
};

/// A PNG file by libpng with the texts as iTXt chunks (UTF-8). Throws what libpng will not write (an image of too many
/// columns).
std::string encodedPng(const PngPixels& pixels, const std::map<std::string, std::string>& texts);

}   // namespace angiopose::io
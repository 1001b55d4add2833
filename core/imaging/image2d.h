#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Plain row-major pixel array; (0, 0) is the top-left pixel.
template <class T>
struct Image2d {
    int width = 0;
    int height = 0;
    std::vector<T> pixels;

    Image2d() = default;
    Image2d(int columns, int rows, T fill = T{})
        : width(columns), height(rows), pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), fill)
    {
    }

    bool isEmpty() const { return pixels.empty(); }
    bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
    T& at(int x, int y) { return pixels[index(x, y)]; }
    const T& at(int x, int y) const { return pixels[index(x, y)]; }
    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

using ImageF = Image2d<float>;
using Mask2d = Image2d<std::uint8_t>;   ///< 0 outside, nonzero inside

/// 8-bit sRGB image for export.
struct ColorImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;   ///< 3 bytes per pixel, row-major, top row first
};

}   // namespace angiopose::core

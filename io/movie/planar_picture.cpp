#include "io/movie/planar_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace angiopose::io {
namespace {

// ITU-R BT.709-6, 3.2 and 3.4
constexpr double redShare = 0.2126, greenShare = 0.7152, blueShare = 0.0722;
constexpr double lumaRange = 219.0, chromaRange = 224.0;

using Rgb = std::array<double, 3>;   // 0…1

Rgb pixelAt(const core::ColorImage& picture, int x, int y)
{
    const auto column = static_cast<std::size_t>(std::clamp(x, 0, picture.width - 1));
    const auto row = static_cast<std::size_t>(std::clamp(y, 0, picture.height - 1));
    const std::uint8_t* pixel = &picture.rgb[3 * (row * static_cast<std::size_t>(picture.width) + column)];
    return {pixel[0] / 255.0, pixel[1] / 255.0, pixel[2] / 255.0};
}

double brightness(const Rgb& color)
{
    return redShare * color[0] + greenShare * color[1] + blueShare * color[2];
}

std::uint8_t byteOf(double value)
{
    return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
}

/// Mean of two rows, and of three columns where the left one of two is the middle.
Rgb aroundPair(const core::ColorImage& picture, int x, int y)
{
    Rgb sum{};
    for (int row = 0; row < 2; ++row) {
        for (int column = -1; column <= 1; ++column) {
            const double weight = column == 0 ? 0.25 : 0.125;
            const Rgb color = pixelAt(picture, x + column, y + row);
            for (std::size_t i = 0; i < sum.size(); ++i) {
                sum[i] += weight * color[i];
            }
        }
    }
    return sum;
}

}   // namespace

PlanarPicture planarPicture(const core::ColorImage& picture)
{
    PlanarPicture planar{picture.width + picture.width % 2, picture.height + picture.height % 2, {}, {}, {}};
    const auto pixels = static_cast<std::size_t>(planar.width) * static_cast<std::size_t>(planar.height);
    planar.luma.reserve(pixels);
    for (int y = 0; y < planar.height; ++y) {
        for (int x = 0; x < planar.width; ++x) {
            planar.luma.push_back(byteOf(16.0 + lumaRange * brightness(pixelAt(picture, x, y))));
        }
    }
    planar.blue.reserve(pixels / 4);
    planar.red.reserve(pixels / 4);
    for (int y = 0; y < planar.height; y += 2) {
        for (int x = 0; x < planar.width; x += 2) {
            const Rgb color = aroundPair(picture, x, y);
            const double light = brightness(color);
            planar.blue.push_back(byteOf(128.0 + chromaRange * 0.5 * (color[2] - light) / (1.0 - blueShare)));
            planar.red.push_back(byteOf(128.0 + chromaRange * 0.5 * (color[0] - light) / (1.0 - redShare)));
        }
    }
    return planar;
}

}   // namespace angiopose::io

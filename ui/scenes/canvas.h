#pragma once

#include "ui/theme/theme.h"

#include <cstddef>
#include <cstdint>

namespace angiopose::ui {

/// Non-owning view of a pixel buffer: 0xFFRRGGBB, rows without padding, top row first.
struct Canvas {
    std::uint32_t* pixels = nullptr;
    int width = 0;
    int height = 0;

    std::uint32_t* row(int y) const { return pixels + static_cast<std::ptrdiff_t>(y) * width; }
    std::size_t pixelCount() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

constexpr std::uint32_t packColor(std::uint8_t red, std::uint8_t green, std::uint8_t blue)
{
    return 0xFF000000U | (static_cast<std::uint32_t>(red) << 16U) | (static_cast<std::uint32_t>(green) << 8U) | blue;
}

constexpr std::uint32_t packColor(const Color& color)
{
    return packColor(color.red, color.green, color.blue);
}

}   // namespace angiopose::ui

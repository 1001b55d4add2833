#pragma once

#include "core/imaging/image2d.h"

#include <array>
#include <cstdint>
#include <vector>

namespace angiopose::io {

/// Palette of one GIF image: at most 255 colors, because one entry is reserved for "unchanged". Gray levels of the
/// image and colors of the overlay have separate entries: gray levels deviate by at most 2, and lines keep their
/// colors.
class GifPalette {
public:
    static constexpr std::uint8_t unchangedIndex = 255;

    explicit GifPalette(const core::ColorImage& image);

    using Color = std::array<std::uint8_t, 3>;
    const std::vector<Color>& colors() const { return colors_; }   ///< palette, at most 255 colors
    std::uint8_t indexOf(const Color& color);   ///< index of the nearest palette color

private:
    std::vector<Color> colors_;
    std::vector<std::uint16_t> nearest_;   ///< cache of palette indices by coarse color, filled on demand
    std::array<std::uint8_t, 256> nearestGray_{};
    bool hasGrays_ = false;
};

}   // namespace angiopose::io

#pragma once

#include "core/imaging/image2d.h"

#include <array>
#include <cstdint>
#include <vector>

namespace angiopose::io {

/// The colours of one picture of a GIF: 255 at most, since one place is kept for "as before". Grey images keep their
/// greys apart from the colours of what is drawn on them, so that neither takes the other's places: grey levels are
/// exact or at most 2 off, lines keep their colours.
class GifPalette {
public:
    static constexpr std::uint8_t asBefore = 255;

    explicit GifPalette(const core::ColorImage& picture);

    using Color = std::array<std::uint8_t, 3>;
    const std::vector<Color>& colors() const { return colors_; }   ///< 255 at most
    std::uint8_t indexOf(const Color& color);   ///< of the nearest one

private:
    std::vector<Color> colors_;
    std::vector<std::uint16_t> nearest_;   ///< by coarse colour, as far as it was asked for
    std::array<std::uint8_t, 256> nearestGray_{};
    bool hasGrays_ = false;
};

}   // namespace angiopose::io

#include "core/tracing/angiogram/frame/drawn_mask.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr float levelTolerance = 0.1F;   // tolerance around either level, as a fraction of the range
constexpr double minTwoLevelFraction = 0.97;   // minimum fraction of pixels at the two levels; others are blurred edges

}   // namespace

std::optional<Mask2d> vesselMaskFromDrawing(const ImageF& image)
{
    const auto [low, high] = std::minmax_element(image.pixels.begin(), image.pixels.end());
    if (image.pixels.empty() || !std::isfinite(*low) || !std::isfinite(*high) || *low == *high) {
        return std::nullopt;
    }
    const float margin = levelTolerance * (*high - *low);
    const float middle = 0.5F * (*low + *high);
    std::size_t black = 0, white = 0;
    for (const float value : image.pixels) {
        black += value <= *low + margin ? 1 : 0;
        white += value >= *high - margin ? 1 : 0;
    }
    const auto count = static_cast<double>(image.pixels.size());
    if (white >= black || static_cast<double>(black + white) < minTwoLevelFraction * count) {
        return std::nullopt;
    }
    Mask2d mask(image.width, image.height);
    std::ranges::transform(image.pixels, mask.pixels.begin(),
                           [middle](float value) { return static_cast<std::uint8_t>(value > middle ? 255 : 0); });
    return mask;
}

}   // namespace angiopose::core

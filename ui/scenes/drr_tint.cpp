#include "ui/scenes/drr_tint.h"

#include "ui/theme/theme.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace angiopose::ui {
namespace {

/// Two source pixels between which a target pixel is interpolated along one axis.
struct Tap {
    int first = -1;   ///< negative if outside the frame
    int second = 0;
    float shareOfSecond = 0.0F;
};

/// Returns the source pixels for each of the `targetSize` canvas pixels that show `low` … `high` of the frame.
std::vector<Tap> tapsOf(double low, double high, int targetSize, int frameSize, int sourceSize)
{
    std::vector<Tap> taps(static_cast<std::size_t>(targetSize));
    for (int k = 0; k < targetSize; ++k) {
        const double inFrame = low + (k + 0.5) * (high - low) / targetSize;
        if (inFrame < -0.5 || inFrame > frameSize - 0.5) {
            continue;
        }
        const double place = std::clamp((inFrame + 0.5) / frameSize * sourceSize - 0.5, 0.0, sourceSize - 1.0);
        const int first = static_cast<int>(place);
        taps[static_cast<std::size_t>(k)] = {first, std::min(first + 1, sourceSize - 1),
                                             static_cast<float>(place - first)};
    }
    return taps;
}

std::uint32_t mixed(std::uint32_t below, const Color& tone, float share)
{
    const auto channel = [share](std::uint32_t from, std::uint8_t to) {
        return static_cast<std::uint8_t>(std::lround((1.0F - share) * static_cast<float>(from & 0xFFU) + share * to));
    };
    return packColor(channel(below >> 16U, tone.red), channel(below >> 8U, tone.green), channel(below, tone.blue));
}

}   // namespace

void DrrTint::setDrr(const core::ImageF& drr)
{
    strength_ = drr;
    revision_ = nextRevision();
    const float strongest =
        strength_.pixels.empty() ? 1.0F : std::max(1e-6F, *std::ranges::max_element(strength_.pixels));
    for (float& pixel : strength_.pixels) {
        pixel = std::sqrt(std::max(0.0F, pixel) / strongest);   // square root to keep thin vessels visible
    }
}

void DrrTint::blend(const Place& place, double opacity, Canvas canvas, const Rows& rows) const
{
    if (isEmpty() || place.frameWidth <= 0 || place.frameHeight <= 0) {
        return;
    }
    const Color tone = branchColors(palette(ThemeMode::Dark)).auxiliary;
    const ViewRect& part = place.part;
    const std::vector<Tap> across = tapsOf(part.left, part.right, canvas.width, place.frameWidth, strength_.width);
    const std::vector<Tap> down = tapsOf(part.top, part.bottom, canvas.height, place.frameHeight, strength_.height);
    for (int y = rows.from; y < rows.to; ++y) {
        const Tap& v = down[static_cast<std::size_t>(y)];
        if (v.first < 0) {
            continue;
        }
        const float* upper = strength_.pixels.data() + strength_.index(0, v.first);
        const float* lower = strength_.pixels.data() + strength_.index(0, v.second);
        std::uint32_t* row = canvas.row(y);
        for (int x = 0; x < canvas.width; ++x) {
            const Tap& u = across[static_cast<std::size_t>(x)];
            if (u.first < 0) {
                continue;
            }
            const float above = upper[u.first] + u.shareOfSecond * (upper[u.second] - upper[u.first]);
            const float below = lower[u.first] + u.shareOfSecond * (lower[u.second] - lower[u.first]);
            const float share =
                static_cast<float>(maxTintOpacity * opacity) * (above + v.shareOfSecond * (below - above));
            if (share > 0.002F) {
                row[x] = mixed(row[x], tone, share);
            }
        }
    }
}

}   // namespace angiopose::ui

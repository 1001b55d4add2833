#include "core/imaging/display_range.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace angiopose::core {
namespace {

constexpr double borderShare = 0.02;   // share of pixels above which an extreme value counts as border or shutter
constexpr double backgroundHeadroom = 0.75;   // contrast range beyond the background, relative to the vessels' contrast

/// Returns at most about 60 000 finite pixels, evenly sampled.
std::vector<float> sampleOf(const ImageF& frame)
{
    const std::size_t step = std::max<std::size_t>(1, frame.pixels.size() / 60000);
    std::vector<float> sample;
    sample.reserve(frame.pixels.size() / step + 1);
    for (std::size_t i = 0; i < frame.pixels.size(); i += step) {
        if (std::isfinite(frame.pixels[i])) {
            sample.push_back(frame.pixels[i]);
        }
    }
    return sample;
}

/// Removes the pixels of a large uniform border or shutter from the sample.
void removeBorder(std::vector<float>& sample)
{
    const auto range = std::ranges::minmax(sample);
    const float lowest = range.min;
    const float highest = range.max;
    const auto count = static_cast<double>(sample.size());
    const auto atLowest = static_cast<double>(std::ranges::count(sample, lowest));
    const auto atHighest = lowest < highest ? static_cast<double>(std::ranges::count(sample, highest)) : 0.0;
    // If little else remains, the extreme value is image content, not a border.
    const bool leavesEnough = count - atLowest - atHighest > 10.0 * borderShare * count;
    const bool dropsLowest = leavesEnough && atLowest > borderShare * count;
    const bool dropsHighest = leavesEnough && atHighest > borderShare * count;
    std::erase_if(sample,
                  [&](float value) { return (dropsLowest && value == lowest) || (dropsHighest && value == highest); });
}

/// Returns the quantile of the sample. Reorders the sample without sorting it, because this runs for every cine frame.
double quantile(std::vector<float>& sample, double fraction)
{
    const auto last = static_cast<double>(sample.size() - 1);
    const auto at = sample.begin() + std::lround(fraction * last);
    std::ranges::nth_element(sample, at);
    return *at;
}

DisplayRange withMinWidth(DisplayRange range)
{
    if (!(range.high > range.low)) {
        range.high = range.low + 1.0;
    }
    return range;
}

}   // namespace

DisplayRange displayRange(const ImageF& frame)
{
    std::vector<float> exposed = sampleOf(frame);
    if (exposed.empty()) {
        return {};
    }
    removeBorder(exposed);
    DisplayRange range{quantile(exposed, 0.005), quantile(exposed, 0.995)};
    // Thin dark (or bright) vessels hardly change the median: keep it away from white (or black).
    const double background = quantile(exposed, 0.5);
    range.high = std::max(range.high, background + backgroundHeadroom * (background - range.low));
    range.low = std::min(range.low, background - backgroundHeadroom * (range.high - background));
    return withMinWidth(range);
}

DisplayRange vesselRange(const ImageF& frame, Polarity polarity)
{
    std::vector<float> exposed = sampleOf(frame);
    if (exposed.empty()) {
        return {};
    }
    removeBorder(exposed);
    const double background = quantile(exposed, 0.5);
    return withMinWidth(polarity == Polarity::VesselsDark ? DisplayRange{quantile(exposed, 0.005), background}
                                                          : DisplayRange{background, quantile(exposed, 0.995)});
}

}   // namespace angiopose::core

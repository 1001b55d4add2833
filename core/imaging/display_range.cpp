#include "core/imaging/display_range.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace core {
namespace {

constexpr double borderShare = 0.02;   // an extreme value that fills more of the frame than this is border or shutter
constexpr double backgroundRoom = 0.75;   // contrast beyond the background, relative to that of the vessels

/// Finite pixels, sorted; at most about 60 000 of them, evenly picked.
std::vector<float> sortedSample(const ImageF& frame)
{
    const std::size_t step = std::max<std::size_t>(1, frame.pixels.size() / 60000);
    std::vector<float> sample;
    sample.reserve(frame.pixels.size() / step + 1);
    for (std::size_t i = 0; i < frame.pixels.size(); i += step) {
        if (std::isfinite(frame.pixels[i])) {
            sample.push_back(frame.pixels[i]);
        }
    }
    std::sort(sample.begin(), sample.end());
    return sample;
}

double quantile(const std::vector<float>& sorted, double fraction)
{
    const auto last = static_cast<double>(sorted.size() - 1);
    return sorted[static_cast<std::size_t>(std::lround(fraction * last))];
}

/// Without a large border of one extreme value.
std::vector<float> exposedField(const std::vector<float>& sample)
{
    const auto enough = static_cast<std::ptrdiff_t>(borderShare * static_cast<double>(sample.size()));
    const auto afterLowest = std::upper_bound(sample.begin(), sample.end(), sample.front());
    const auto firstHighest = std::lower_bound(afterLowest, sample.end(), sample.back());
    const bool leavesEnough = firstHighest - afterLowest > 10 * enough;   // else the extreme is the picture itself
    const bool dropsLowest = leavesEnough && afterLowest - sample.begin() > enough;
    const bool dropsHighest = leavesEnough && sample.end() - firstHighest > enough;
    return {dropsLowest ? afterLowest : sample.begin(), dropsHighest ? firstHighest : sample.end()};
}

DisplayRange notEmpty(DisplayRange range)
{
    if (!(range.high > range.low)) {
        range.high = range.low + 1.0;
    }
    return range;
}

}   // namespace

DisplayRange displayRange(const ImageF& frame)
{
    const std::vector<float> sample = sortedSample(frame);
    if (sample.empty()) {
        return {};
    }
    const std::vector<float> exposed = exposedField(sample);
    DisplayRange range{quantile(exposed, 0.005), quantile(exposed, 0.995)};
    // Thin dark vessels (or bright ones) hardly move the median: keep it away from white (from black).
    const double background = quantile(exposed, 0.5);
    range.high = std::max(range.high, background + backgroundRoom * (background - range.low));
    range.low = std::min(range.low, background - backgroundRoom * (range.high - background));
    return notEmpty(range);
}

DisplayRange vesselRange(const ImageF& frame, Polarity polarity)
{
    const std::vector<float> sample = sortedSample(frame);
    if (sample.empty()) {
        return {};
    }
    const std::vector<float> exposed = exposedField(sample);
    const double background = quantile(exposed, 0.5);
    return notEmpty(polarity == Polarity::VesselsDark ? DisplayRange{quantile(exposed, 0.005), background}
                                                      : DisplayRange{background, quantile(exposed, 0.995)});
}

}   // namespace core

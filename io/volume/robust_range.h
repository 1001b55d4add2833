#pragma once

#include "io/volume/quantization.h"

#include <algorithm>
#include <vector>

namespace angiopose::io {

/// Returns the range of values to map to the 65536 levels: all of `range`, unless `range` is more than a thousand times
/// as wide as the span of nearly all values; then excludes far outliers (such as a single 1e38 in a scan). `valueAt(i)`
/// returns the i-th of `count` values.
template <class ValueAt>
ValueRange robustRange(const ValueRange& range, std::size_t count, const ValueAt& valueAt)
{
    constexpr std::size_t sampleSize = 200'000;
    constexpr std::size_t minSample = 100;
    constexpr double maxRangeRatio = 1000.0;   // ratio beyond which nearly all values would share 65 levels
    constexpr double margin = 10.0;   // on both sides, in multiples of that span: keeps metal and bright vessels
    if (range.high - range.low <= storedLevels) {
        return range;
    }
    std::vector<double> sample;
    for (std::size_t i = 0; i < count; i += std::max<std::size_t>(1, count / sampleSize)) {
        if (const double value = valueAt(i); std::isfinite(value)) {
            sample.push_back(value);
        }
    }
    if (sample.empty()) {
        return range;
    }
    std::ranges::sort(sample);
    const double median = sample[sample.size() / 2];   // background of a mask or map, excluded from the spread
    std::erase(sample, median);
    if (sample.size() < minSample) {
        return range;
    }
    const double low = std::min(median, sample[sample.size() / 200]);
    const double high = std::max(median, sample[sample.size() - 1 - sample.size() / 200]);
    if (range.high - range.low <= maxRangeRatio * (high - low)) {
        return range;
    }
    ValueRange useful = range;
    useful.low = std::numeric_limits<double>::infinity();
    useful.high = -useful.low;
    for (std::size_t i = 0; i < count; ++i) {
        const double value = valueAt(i);
        if (value >= low - margin * (high - low) && value <= high + margin * (high - low)) {
            useful.low = std::min(useful.low, value);
            useful.high = std::max(useful.high, value);
        }
    }
    return useful;
}

/// Returns the number of finite values outside a range.
template <class ValueAt>
std::size_t countOutside(const ValueRange& range, std::size_t count, const ValueAt& valueAt)
{
    std::size_t outside = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double value = valueAt(i);
        outside += std::isfinite(value) && (value < range.low || value > range.high) ? 1 : 0;
    }
    return outside;
}

}   // namespace angiopose::io

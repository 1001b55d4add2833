#pragma once

#include "io/messages/says.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>

namespace angiopose::io {

inline constexpr double lowestStored = -32768.0;
inline constexpr double storedLevels = 65535.0;

/// What a first pass over values of a wide type finds.
struct ValueRange {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    bool isWhole = true;   ///< every finite value is a whole number
    std::size_t missing = 0;   ///< NaN or infinite

    void add(double value)
    {
        if (!std::isfinite(value)) {
            ++missing;
            return;
        }
        low = std::min(low, value);
        high = std::max(high, value);
        isWhole = isWhole && value == std::floor(value);
    }
};

/// How values become 16-bit voxels: value = scale · voxel + offset.
struct Quantization {
    double scale = 1.0;
    double offset = 0.0;

    std::int16_t voxel(double value) const
    {
        const double level = std::round((value - offset) / scale);
        return std::isnan(level)
                   ? static_cast<std::int16_t>(lowestStored)
                   : static_cast<std::int16_t>(std::clamp(level, lowestStored, lowestStored + storedLevels));
    }
};

/// Keeps whole numbers that span no more than 16 bit; spreads others over the 65536 levels.
inline Quantization quantizationOf(const ValueRange& range)
{
    if (range.isWhole && range.low >= lowestStored && range.high <= lowestStored + storedLevels) {
        return {};
    }
    if (range.isWhole && range.high - range.low <= storedLevels) {
        return {1.0, range.low - lowestStored};
    }
    const double scale = range.high > range.low ? (range.high - range.low) / storedLevels : 1.0;
    return {scale, range.low - scale * lowestStored};
}

/// "The float32 voxels are rounded to 16 bit, in steps of 0.00153."
inline core::Message roundingNote(double step, const std::string& type)
{
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.3g", std::abs(step));
    return says::volumeRounded(type, text.data());
}

}   // namespace angiopose::io
#pragma once

#include "io/messages/messages.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace angiopose::io {

inline constexpr double minStoredValue = -32768.0;
inline constexpr double storedLevels = 65535.0;

/// Range of values of a wide type, determined in a first pass.
struct ValueRange {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    bool isInteger = true;   ///< whether every finite value is a whole number, up to float rounding
    std::size_t missing = 0;   ///< number of NaN or infinite values

    void add(double value)
    {
        if (!std::isfinite(value)) {
            ++missing;
            return;
        }
        low = std::min(low, value);
        high = std::max(high, value);
        const double whole = std::round(value);
        isInteger = isInteger && std::abs(value - whole) <= std::min(2e-7 * std::abs(whole), 1e-3);
    }
};

/// Conversion of values to 16-bit voxels: value = scale · voxel + offset.
struct Quantization {
    double scale = 1.0;
    double offset = 0.0;

    std::int16_t voxel(double value) const
    {
        const double level = std::round((value - offset) / scale);
        return std::isnan(level)
                   ? static_cast<std::int16_t>(minStoredValue)
                   : static_cast<std::int16_t>(std::clamp(level, minStoredValue, minStoredValue + storedLevels));
    }
};

/// Keeps whole numbers that span at most 16 bits; maps other values to 65536 levels.
inline Quantization quantizationOf(const ValueRange& range)
{
    if (range.isInteger && range.low >= minStoredValue && range.high <= minStoredValue + storedLevels) {
        return {};
    }
    if (range.isInteger && range.high - range.low <= storedLevels) {
        return {1.0, range.low - minStoredValue};
    }
    const double scale = range.high > range.low ? (range.high - range.low) / storedLevels : 1.0;
    return {scale, range.low - scale * minStoredValue};
}

/// Returns a note such as "The float32 voxels are rounded to 16 bit, in steps of 0.00153."
inline core::Message roundingNote(double step, const std::string& type)
{
    std::array<char, 32> text;
    const auto end = std::to_chars(text.begin(), text.end(), std::abs(step), std::chars_format::general, 3).ptr;
    return messages::volumeRounded(type, std::string(text.begin(), end));
}

}   // namespace angiopose::io

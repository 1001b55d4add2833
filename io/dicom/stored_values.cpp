#include "io/dicom/stored_values.h"

#include "io/support/numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace angiopose::io {
namespace {

constexpr float maxStored = 65535.0F;
constexpr std::size_t maxDecimalString = 16;

}   // namespace

std::string decimalString(double value)
{
    std::string text = toText(value);
    for (int digits = 15; text.size() > maxDecimalString; --digits) {
        std::array<char, 40> buffer;
        const auto end =
            std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits).ptr;
        text.assign(buffer.data(), end);
    }
    return text;
}

StoredValues storedValuesOf(const std::vector<core::ImageF>& frames)
{
    bool isWhole = true;
    float low = frames.front().pixels.front();
    float high = low;
    for (const core::ImageF& frame : frames) {
        for (const float value : frame.pixels) {
            isWhole = isWhole && value >= 0.0F && value <= maxStored && value == std::floor(value);
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    StoredValues stored;
    double slope = 1.0, intercept = 0.0;
    if (!isWhole) {
        // The header stores 16 characters per number, so use these rounded numbers instead of the exact ones.
        stored.intercept = decimalString(low);
        intercept = parseNumber(stored.intercept).value_or(0.0);
        stored.slope = decimalString(high > low ? (high - intercept) / maxStored : 1.0);
        slope = parseNumber(stored.slope).value_or(1.0);
    }
    stored.pixels.reserve(frames.size() * frames.front().pixels.size());
    for (const core::ImageF& frame : frames) {
        for (const float value : frame.pixels) {
            const double level = std::round((value - intercept) / slope);
            stored.pixels.push_back(static_cast<std::uint16_t>(std::clamp(level, 0.0, double{maxStored})));
        }
    }
    return stored;
}

}   // namespace angiopose::io

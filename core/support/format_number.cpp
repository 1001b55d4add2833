#include "core/support/format_number.h"

#include <array>
#include <charconv>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double minFixedValue = 1e-3;

std::string formatNumber(double value, std::chars_format format, int decimals)
{
    std::array<char, 400> buffer;   // the largest double has 309 digits
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, decimals).ptr;
    return {buffer.data(), end};
}

}   // namespace

std::string fixedText(double value, int decimals)
{
    return std::isfinite(value) ? formatNumber(value, std::chars_format::fixed, decimals) : "–";
}

std::string significantText(double value)
{
    if (value == 0.0) {
        return "0";
    }
    return std::isfinite(value) && std::abs(value) < minFixedValue
               ? formatNumber(value, std::chars_format::scientific, 1)
               : fixedText(value, 3);
}

std::string plainText(double value)
{
    return formatNumber(value, std::chars_format::general, 6);
}

}   // namespace angiopose::core

#include "app/texts/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace angiopose::app {

std::string fixedText(double value, int decimals)
{
    if (!std::isfinite(value)) {
        return "n/a";
    }
    std::array<char, 64> buffer{};
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
    std::string text = end.ec == std::errc{} ? std::string(buffer.data(), end.ptr) : std::to_string(value);
    const bool isNegativeZero = text.front() == '-' && text.find_first_of("123456789") == std::string::npos;
    return isNegativeZero ? text.substr(1) : text;
}

std::string primaryAngleText(double primaryAngleDeg)
{
    return (primaryAngleDeg < 0.0 ? "RAO " : "LAO ") + fixedText(std::abs(primaryAngleDeg), 1);
}

std::string secondaryAngleText(double secondaryAngleDeg)
{
    return (secondaryAngleDeg < 0.0 ? "CAU " : "CRA ") + fixedText(std::abs(secondaryAngleDeg), 1);
}

}   // namespace angiopose::app

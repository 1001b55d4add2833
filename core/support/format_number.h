#pragma once

#include <string>

namespace angiopose::core {

/// Formats `value` with this number of decimals and `.` in every locale; "–" if it is not finite.
std::string fixedText(double value, int decimals);

/// Formats with three decimals, or a power of ten if these would show only zeros: "12.345", "3.2e-07", "0".
std::string significantText(double value);

/// Formats with up to six significant digits and no more than needed: "4", "0.2", "1e+06".
std::string plainText(double value);

}   // namespace angiopose::core
#pragma once

#include <string>

namespace angiopose::core {

/// Formats `value` with this number of decimals and `.` in every locale; "–" if it is not finite.
std::string fixedText(double value, int decimals);

/// Formats with three decimals, or with an exponent if these decimals would all be zero: "12.345", "3.2e-07", "0".
std::string significantText(double value);

/// Formats with as many significant digits as needed, at most six: "4", "0.2", "1e+06".
std::string plainText(double value);

}   // namespace angiopose::core

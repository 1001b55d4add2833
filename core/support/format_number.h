#pragma once

#include <string>

namespace angiopose::core {

/// `value` with so many decimals and `.` in every locale; "–" when it is not finite.
std::string fixedText(double value, int decimals);

/// Three decimals, or a power of ten where these would show nothing: "12.345", "3.2e-07", "0".
std::string significantText(double value);

/// Up to six significant digits and no more than needed: "4", "0.2", "1e+06".
std::string plainText(double value);

}   // namespace angiopose::core
#pragma once

#include <string>

namespace angiopose::app {

/// Formats a number with a fixed number of decimals and '.' in every locale, e.g. "12.34"; "n/a" if it is not finite.
std::string fixedText(double value, int decimals);

/// Format gantry angles: "LAO 30.0" or "RAO 12.5", "CRA …" or "CAU …".
std::string primaryAngleText(double primaryAngleDeg);
std::string secondaryAngleText(double secondaryAngleDeg);

}   // namespace angiopose::app

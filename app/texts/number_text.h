#pragma once

#include <string>

namespace angiopose::app {

/// "12.34": fixed number of decimals, '.' in every locale. "n/a" if not finite.
std::string fixedText(double value, int decimals);

/// "LAO 30.0" or "RAO 12.5"; "CRA …" or "CAU …".
std::string primaryAngleText(double primaryAngleDeg);
std::string secondaryAngleText(double secondaryAngleDeg);

}   // namespace angiopose::app
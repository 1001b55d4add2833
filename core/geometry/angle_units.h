#pragma once

#include <numbers>

namespace angiopose::core {

inline constexpr double radiansPerDegree = std::numbers::pi / 180.0;
inline constexpr double degreesPerRadian = 180.0 / std::numbers::pi;

}   // namespace angiopose::core

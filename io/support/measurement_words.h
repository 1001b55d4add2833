#pragma once

#include <array>

namespace angiopose::io {

/// Words of files for core::MeasurementKind and core::MeasurementPlane, in their order.
inline constexpr std::array measurementKinds{"length", "angle", "area"};
inline constexpr std::array measurementPlanes{"vessels", "detector", "pixels"};

}   // namespace angiopose::io

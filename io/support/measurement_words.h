#pragma once

#include <array>

namespace angiopose::io {

/// Names that files use for core::MeasurementKind, core::MeasurementPlane, core::VesselMarkKind, core::AnnotationKind
/// and core::BodyPlane, in enumerator order.
inline constexpr std::array measurementKinds{"length", "angle", "area"};
inline constexpr std::array measurementPlanes{"vessels", "detector", "pixels", "typed"};
inline constexpr std::array markKinds{"check-point", "ostium-ring"};
inline constexpr std::array annotationKinds{"arrow", "text"};
inline constexpr std::array bodyPlaneWords{"axial", "coronal", "sagittal"};

}   // namespace angiopose::io

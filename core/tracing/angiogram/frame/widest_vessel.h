#pragma once

#include "core/geometry/c_arm.h"
#include "core/tracing/angiogram/frame/trace_options.h"

namespace angiopose::core {

inline constexpr double defaultMaxVesselRadiusPx = 8.0;

/// Returns the radius of the widest vessel to search for, px of a frame of typical size (see `WorkingSize`): a left
/// main artery of 5 mm diameter, converted by pixel spacing and magnification, limited to 8 to 24 px; 8 if the spacing
/// is unknown.
double widestVesselRadiusPx(const CArm& cArm, int width, int height);

/// Returns the options with `maxVesselRadiusPx` set if it was 0.
TraceOptions resolveOptions(TraceOptions options, const CArm& cArm = {}, int width = 0, int height = 0);

}   // namespace angiopose::core

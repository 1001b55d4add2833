#pragma once

#include "core/geometry/c_arm.h"
#include "core/tracing/angiogram/frame/trace_options.h"

namespace angiopose::core {

inline constexpr double usualMaxVesselRadiusPx = 8.0;

/// The radius of the widest vessel to look for, px of a frame of usual size (see `WorkingSize`): a left main artery of
/// 5 mm by pixel spacing and magnification, within 8 to 24 px; 8 where the spacing is not known.
double widestVesselRadiusPx(const CArm& cArm, int width, int height);

/// The options with the widest vessel settled, where they leave it open.
TraceOptions settledFor(TraceOptions options, const CArm& cArm = {}, int width = 0, int height = 0);

}   // namespace angiopose::core

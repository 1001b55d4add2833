#pragma once

#include "core/geometry/projection_camera.h"
#include "core/support/random.h"
#include "core/vessel/centerline2d.h"

namespace angiopose::core {

/// Returns an exact target degraded by simulated tracing errors (ALGORITHMS §4.4, "oracle + noise"): a fifth of the
/// branches missing, jitter of σ 0.7 px correlated over about five points, rounding to whole pixels, and one spurious
/// curve of about 500 px (id −1).
Centerline2d addTracingErrors(const Centerline2d& exact, const ProjectionCamera& camera, CounterRandom random);

/// Parameters of these tracing errors, from which the error bound is computed (evaluation/trial/cramer_rao_bound.h).
inline constexpr double degradedJitterPx = 0.7;
inline constexpr double degradedCorrelationPoints = 5.0;   ///< correlation length; the points are 1 px apart

}   // namespace angiopose::core

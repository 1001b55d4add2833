#pragma once

#include "core/geometry/projection_camera.h"
#include "core/support/random.h"
#include "core/vessel/centerline2d.h"

namespace benchmarks {

/// What tracing would make of an exact target (ALGORITHMS §4.4, "oracle + noise"): a fifth of the branches missing,
/// jitter of σ 0.7 px correlated over about five points, whole pixels, and one stray curve of about 500 px.
core::Centerline2d degraded(const core::Centerline2d& exact, const core::ProjectionCamera& camera,
                            core::CounterRandom random);

}   // namespace benchmarks

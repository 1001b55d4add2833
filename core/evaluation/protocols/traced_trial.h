#pragma once

#include "core/evaluation/trial/trial.h"
#include "core/simulation/simulated_case.h"

namespace angiopose::core {

/// The first frame of a simulated view through the real tracing, the start pose as its header gives it. A view whose
/// tracing fails keeps an empty target: every method then fails on it.
Trial tracedTrial(const SimulatedCase& view);

}   // namespace angiopose::core
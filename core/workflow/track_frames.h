#pragma once

#include "core/case/case.h"
#include "core/case/registration_input.h"
#include "core/case/tracked_run.h"
#include "core/registration/run_periods.h"
#include "core/workflow/observer.h"

#include <vector>

namespace angiopose::core {

/// Tracks the vessels from the case's frame and pose to the end of the run, then back to its beginning (ALGORITHMS
/// §6.11). Returns the frames in order; when stopped, only those already tracked. Vessels with a known deformation in
/// the case's frame are tracked as deformed, with the deformation smoothed over time (§11.6). Fails if the case is not
/// ready, if the target of its frame is given instead of traced, or if the gantry rotates during the run.
Result<std::vector<TrackedRunFrame>> trackFrames(const Case& session, const WorkObserver& observe = {});

/// Returns the respiratory and cardiac periods estimated from the tracked frames, if the angiogram specifies the time
/// between frames.
RunPeriods periodsOf(const Case& session, const std::vector<TrackedRunFrame>& frames);

}   // namespace angiopose::core

#pragma once

#include "core/case/case.h"
#include "core/case/followed_run.h"
#include "core/case/registration_input.h"
#include "core/registration/run_periods.h"
#include "core/workflow/observer.h"

#include <vector>

namespace angiopose::core {

/// Follows the vessels from the case's frame and pose to the end of the run, then back to its beginning
/// (ALGORITHMS §6.11); frames in order, a stopped run only as far as it came. Vessels that are known to be bent in the
/// case's frame are followed bent, and smoothed in time (§11.6). Fails where the case is not ready, where
/// its frame's target is given rather than traced, or where the gantry turns during the run.
Result<std::vector<FollowedFrame>> followFrames(const Case& session, const WorkObserver& observe = {});

/// Breath and heart in what was followed, where the angiogram tells the time between frames.
RunPeriods periodsOf(const Case& session, const std::vector<FollowedFrame>& frames);

}   // namespace angiopose::core
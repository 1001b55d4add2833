#pragma once

#include "core/case/registration_input.h"
#include "core/registration/run_periods.h"
#include "core/registration/track_frames.h"
#include "core/workflow/observer.h"

#include <memory>
#include <optional>
#include <vector>

namespace angiopose::core {

/// Where the vessels are in one frame of a run.
struct FollowedFrame {
    int frame = 0;
    TrackedFrame tracked;   ///< without a traced vessel: the pose of the frame before, not trustworthy
    std::optional<Message> problem;   ///< why nothing was traced
    /// How the vessels are bent there, beside that pose; null where they are not, or were not found bent before.
    std::shared_ptr<const DeformableResult> bent{};
    std::optional<int> bentAsInFrame{};   ///< the nearest that shows them, where this one does not
};

/// Follows the vessels from the case's frame and pose to the end of the run, then back to its beginning
/// (ALGORITHMS §6.11); frames in order, a stopped run only as far as it came. Vessels that are known to be bent in the
/// case's frame are followed bent, and smoothed in time (§11.6). Fails where the case is not ready, where
/// its frame's target is given rather than traced, or where the gantry turns during the run.
Result<std::vector<FollowedFrame>> followFrames(const Case& theCase, const WorkObserver& observe = {});

/// For the view that was followed; null where no vessels were found bent.
std::shared_ptr<const FollowedBends> bendsOf(const std::vector<FollowedFrame>& frames);

/// Breath and heart in what was followed, where the angiogram tells the time between frames.
RunPeriods periodsOf(const Case& theCase, const std::vector<FollowedFrame>& frames);

}   // namespace angiopose::core
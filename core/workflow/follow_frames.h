#pragma once

#include "core/case/registration_input.h"
#include "core/registration/track_frames.h"
#include "core/workflow/observer.h"

#include <optional>
#include <vector>

namespace angiopose::core {

/// Where the vessels are in one frame of a run.
struct FollowedFrame {
    int frame = 0;
    TrackedFrame tracked;   ///< without a traced vessel: the pose of the frame before, not trustworthy
    std::optional<Message> problem;   ///< why nothing was traced
};

/// Follows the vessels from the case's frame and pose to the end of the run, then back to its beginning
/// (ALGORITHMS §6.11); frames in order, a stopped run only as far as it came. Fails where the case is not ready, where
/// its frame's target is given rather than traced, or where the gantry turns during the run.
Result<std::vector<FollowedFrame>> followFrames(const Case& theCase, const WorkObserver& observe = {});

}   // namespace angiopose::core
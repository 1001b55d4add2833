#pragma once

#include "core/case/input_file.h"
#include "core/registration/deformable/deform_vessels.h"
#include "core/registration/tracked_frame.h"
#include "core/support/message.h"

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
    std::shared_ptr<const DeformableResult> deformed{};
    std::optional<int> deformedAsInFrame{};   ///< the nearest that shows them, where this one does not
};

/// What following found in the run of a view (workflow/follow_frames).
struct FollowedRun {
    std::shared_ptr<const std::vector<FollowedFrame>> frames;   ///< in order; null: it was not followed
    int fromFrame = 0;   ///< whose pose was given
    InputFile deformationsFile;   ///< that a case file names for the bends; no path: they come from no file
};

FollowedRun followedFrom(int frame, std::vector<FollowedFrame> frames);

/// All of them; empty where the run was not followed.
const std::vector<FollowedFrame>& framesOf(const FollowedRun& run);

const FollowedFrame* findFrame(const FollowedRun& run, int frame);   ///< null: none

/// The frame that has the vessels bent at a pose; null where there is none.
const FollowedFrame* deformationAt(const FollowedRun& run, const RigidTransform& cameraFromPatient);

/// Bent in the frame itself, rather than as in another.
bool isDeformedByItself(const FollowedFrame& frame);

/// The vessels bent as in a frame that shows them, at the pose of another.
std::shared_ptr<const DeformableResult> carriedDeformation(const FollowedFrame& from,
                                                           const RigidTransform& cameraFromPatient);

}   // namespace angiopose::core

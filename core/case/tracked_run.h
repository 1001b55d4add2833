#pragma once

#include "core/case/input_file.h"
#include "core/registration/deformable/deform_vessels.h"
#include "core/registration/tracked_frame.h"
#include "core/support/message.h"

#include <memory>
#include <optional>
#include <vector>

namespace angiopose::core {

/// Pose of the vessels in one frame of a cine run.
struct TrackedRunFrame {
    int frame = 0;
    TrackedFrame tracked;   ///< if no vessel was traced, the pose of the previous frame, marked as unreliable
    std::optional<Message> problem;   ///< why no vessel was traced; empty if the frame was traced
    /// Deformation of the vessels in this frame, relative to the pose in `tracked`; null if none was found.
    std::shared_ptr<const DeformableResult> deformed{};
    std::optional<int>
        deformationSourceFrame{};   ///< frame from which the deformation was taken, if this frame had none
};

/// Result of tracking the vessels through the cine run of a view (workflow/track_frames).
struct TrackedRun {
    std::shared_ptr<const std::vector<TrackedRunFrame>> frames;   ///< in frame order; null if the run was not tracked
    int startFrame = 0;   ///< frame with the given pose, at which tracking started
    InputFile deformationsFile;   ///< file from which the deformations were read; its path is empty if there is none
};

TrackedRun makeTrackedRun(int frame, std::vector<TrackedRunFrame> frames);

/// Returns all tracked frames; empty if the run was not tracked.
const std::vector<TrackedRunFrame>& framesOf(const TrackedRun& run);

const TrackedRunFrame* findFrame(const TrackedRun& run, int frame);   ///< null if there is none

/// Returns the tracked frame at exactly this pose if it has a deformation; null otherwise.
const TrackedRunFrame* findDeformedFrame(const TrackedRun& run, const RigidTransform& cameraFromPatient);

/// Whether the deformation was found in the frame itself and not taken from another frame.
bool hasOwnDeformation(const TrackedRunFrame& frame);

/// Returns the deformation found in one frame, transferred to the pose of another frame.
std::shared_ptr<const DeformableResult> transferDeformation(const TrackedRunFrame& from,
                                                            const RigidTransform& cameraFromPatient);

}   // namespace angiopose::core

#pragma once

#include "core/registration/deformable/deformation_tracker.h"
#include "core/registration/track_frames.h"

#include <memory>
#include <optional>

namespace angiopose::core {

/// Vessel pose in a frame and the deformation relative to that pose.
struct TrackedVessels {
    TrackedFrame tracked;
    std::shared_ptr<const DeformableResult>
        deformed;   ///< null: not deformed, undetermined, or rigid vessels are tracked
};

/// Tracks vessels, deformed or not, from frame to frame of one view. Deformed vessels keep their deformation from the
/// previous frame for the rigid step; then the deformation is refined in every frame (ALGORITHMS §11.6).
class RunFollower {
public:
    /// `input` has the pose of the frame before the first tracked one as its initial pose, and that frame's target.
    /// `bent` is the deformation found there, in this view only, or null. Fails on unusable input.
    static Result<RunFollower> from(const RegistrationInput& input,
                                    const std::shared_ptr<const DeformableResult>& deformed,
                                    const RegistrationOptions& options);

    /// Fails when the target is empty or not finite, leaving the tracker unchanged.
    Result<TrackedVessels> next(const Centerline2d& target, const SearchObserver& observe = {});

private:
    RunFollower(RegistrationInput input, const RegistrationOptions& options, FrameTracker tracker,
                std::optional<DeformationTracker> deformations);

    RegistrationInput input_;   ///< with the undeformed tree
    RegistrationOptions options_;
    FrameTracker tracker_;
    std::optional<DeformationTracker> deformations_;
};

}   // namespace angiopose::core

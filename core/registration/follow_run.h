#pragma once

#include "core/registration/deformable/deformation_tracker.h"
#include "core/registration/track_frames.h"

#include <memory>
#include <optional>

namespace angiopose::core {

/// Where the vessels are in a frame, and how they are bent beside that pose.
struct TrackedVessels {
    TrackedFrame tracked;
    std::shared_ptr<const DeformableResult> deformed;   ///< null: not bent, not told, or rigid vessels are followed
};

/// Follows vessels, bent or not, from frame to frame of one view. Bent ones move on as they were bent in the
/// frame before; beside that motion the bend of every frame is found from there (ALGORITHMS §11.6).
class RunFollower {
public:
    /// `input` with the pose of the frame before the first one followed as its start, and that frame's target. `bent`:
    /// what bending found there, of this view alone, or null. Fails on unusable input.
    static Result<RunFollower> from(const RegistrationInput& input,
                                    const std::shared_ptr<const DeformableResult>& deformed,
                                    const RegistrationOptions& options);

    /// Fails when the target is empty or not finite, and stays as it was.
    Result<TrackedVessels> next(const Centerline2d& target, const SearchObserver& observe = {});

private:
    RunFollower(RegistrationInput input, const RegistrationOptions& options, FrameTracker tracker,
                std::optional<DeformationTracker> deformations);

    RegistrationInput input_;   ///< of the tree as it was scanned
    RegistrationOptions options_;
    FrameTracker tracker_;
    std::optional<DeformationTracker> deformations_;
};

}   // namespace angiopose::core

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
        deformed;   ///< null if the vessels are tracked as rigid, or if the deformation is undetermined or zero
};

/// Tracks rigid or deformed vessels through the frames of one view. For deformed vessels, the rigid registration uses
/// the deformation of the previous frame, which is then refined in the current one (ALGORITHMS §11.6).
class VesselTracker {
public:
    /// `input` holds the target of the frame before the first tracked one and, as initial pose, that frame's pose.
    /// `deformed` is the deformation in that frame, from this view only, or null. Fails on unusable input.
    static Result<VesselTracker> from(const RegistrationInput& input,
                                      const std::shared_ptr<const DeformableResult>& deformed,
                                      const RegistrationOptions& options);

    /// Tracks the next frame. If the target is empty or not finite, fails and leaves the tracker unchanged.
    Result<TrackedVessels> next(const Centerline2d& target, const SearchObserver& observe = {});

private:
    VesselTracker(RegistrationInput input, const RegistrationOptions& options, FrameTracker tracker,
                  std::optional<DeformationTracker> deformations);

    RegistrationInput input_;   ///< input with the undeformed tree
    RegistrationOptions options_;
    FrameTracker tracker_;
    std::optional<DeformationTracker> deformations_;
};

}   // namespace angiopose::core

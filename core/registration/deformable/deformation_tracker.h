#pragma once

#include "core/registration/deformable/deformation_problem.h"

#include <optional>

namespace angiopose::core {

/// Tracks deformed vessels through a cine run (ALGORITHMS §11.6). Each frame starts from the deformation of the
/// previous one and needs only a few steps instead of the three fits of a cold start. If too little of the tree then
/// matches a vessel, the frame is fitted from scratch.
class DeformationTracker {
public:
    /// Continues from the deformation `previous`, found in one frame of this view alone; fails if the view is unusable.
    static Result<DeformationTracker> after(const DeformableView& view, DeformableResult previous,
                                            const DeformableOptions& options = {});

    /// Computes the deformation of the next frame near its rigid pose. If the target is unusable, fails and leaves the
    /// tracker unchanged.
    Result<DeformableResult> next(const DeformableView& view, const IterationObserver& observe = {});

private:
    DeformationTracker(DeformationProblem problem, DeformableResult previous, const RigidTransform& rigid,
                       const DeformableOptions& options);
    DeformableResult makeWarmStart(const DeformableView& view);
    DeformationState shiftedInitialState(const DeformableView& view) const;

    DeformableOptions options_;
    DeformationProblem problem_;
    DeformableResult lastResult_;
    RigidTransform lastRigidPose_;   ///< rigid pose of the frame to which lastResult_ belongs
    std::optional<MotionVariances> variances_;   ///< motion variances estimated in the previous frame
};

}   // namespace angiopose::core

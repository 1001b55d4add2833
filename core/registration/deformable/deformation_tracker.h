#pragma once

#include "core/registration/deformable/deformation_problem.h"

#include <optional>

namespace angiopose::core {

/// Tracks deformed vessels through the frames of a run (ALGORITHMS §11.6): each frame starts from the deformation of
/// the previous one and needs a few steps where a cold start takes three fits. If only little of the tree finds a
/// matching vessel that way, the frame is fitted from scratch.
class DeformationTracker {
public:
    /// Continues from the deformation `known` found in one frame, in that view only; fails if the view is unusable.
    static Result<DeformationTracker> after(const DeformableView& view, DeformableResult known,
                                            const DeformableOptions& options = {});

    /// Computes the deformation of the next frame near its rigid pose; fails if its target is unusable, leaving the
    /// tracker unchanged.
    Result<DeformableResult> next(const DeformableView& view, const IterationObserver& observe = {});

private:
    DeformationTracker(DeformationProblem problem, DeformableResult known, const RigidTransform& rigid,
                       const DeformableOptions& options);
    DeformableResult warm(const DeformableView& view);
    DeformationState startOf(const DeformableView& view) const;

    DeformableOptions options_;
    DeformationProblem problem_;
    DeformableResult last_;
    RigidTransform lastRigid_;   ///< rigid pose of the frame of `last_`
    std::optional<MotionVariances> variances_;   ///< variances estimated in the last frames
};

}   // namespace angiopose::core

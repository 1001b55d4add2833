#pragma once

#include "core/registration/deformable/deformation_problem.h"

#include <optional>

namespace angiopose::core {

/// Follows bent vessels through the frames of a run (ALGORITHMS §11.6): each frame starts from the bend of the one
/// before and needs a few steps where a cold start takes three runs. Where little of the tree finds its vessel that
/// way, the frame is bent from nothing.
class DeformationTracker {
public:
    /// Goes on from what bending found in one frame, `known`, in its view alone; fails where that cannot be used.
    static Result<DeformationTracker> after(const DeformableView& view, DeformableResult known,
                                            const DeformableOptions& options = {});

    /// The bend of the next frame, near its rigid pose; fails where its target cannot be used, and stays as it was.
    Result<DeformableResult> next(const DeformableView& view, const IterationObserver& observe = {});

private:
    DeformationTracker(DeformationProblem problem, DeformableResult known, const RigidTransform& rigid,
                       const DeformableOptions& options);
    DeformableResult warm(const DeformableView& view);
    DeformationState startOf(const DeformableView& view) const;

    DeformableOptions options_;
    DeformationProblem problem_;
    DeformableResult last_;
    RigidTransform lastRigid_;   ///< of the frame of `last_`
    std::optional<MotionVariances> variances_;   ///< as the last frame taught them
};

}   // namespace angiopose::core

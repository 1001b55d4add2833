#pragma once

#include "core/registration/pose/pose_freedom.h"

namespace angiopose::core {

/// What motions about the X-ray source may change: poses are cameraFromStart, steps are twists ξ (rad, mm) with
/// pose ← exp(ξ) pose.
class SourceFreedom {
public:
    /// All six are free.
    SourceFreedom() = default;

    /// `freedom`: of cameraFromPatient; `start` and the tree's centroid (patient mm) say where it stands.
    SourceFreedom(const PoseFreedom& freedom, const RigidTransform& start, const Eigen::Vector3d& centroidInPatient);

    bool isFull() const { return freedom_.isFull(); }
    const PoseFreedom& aboutCentroid() const { return freedom_; }
    const Eigen::Vector3d& centroidInStart() const { return centroidInStart_; }

    /// The step by core::dampedStep among those allowed. With Freedom::Rotation the tree turns about the source, as far
    /// as locked shifts let it.
    Vector6d dampedStep(const NormalEquations& equations, double damping, const RigidTransform& pose,
                        Freedom freedom = Freedom::Full) const;

    /// The allowed direction down a gradient, components weighed by `weights` (one for turns, one for shifts).
    Vector6d descent(const Vector6d& gradient, const Vector6d& weights, const RigidTransform& pose,
                     Freedom freedom) const;

    /// The pose after a twist; what is locked keeps its value exactly.
    RigidTransform moved(const RigidTransform& pose, const Vector6d& twist) const;

private:
    StepBasis freeTwists(const RigidTransform& pose, Freedom freedom) const;

    PoseFreedom freedom_;
    Eigen::Vector3d centroidInStart_ = Eigen::Vector3d::Zero();
};

}   // namespace angiopose::core
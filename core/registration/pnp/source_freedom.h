#pragma once

#include "core/registration/pose/pose_freedom.h"

namespace angiopose::core {

/// Allowed motions about the X-ray source. Poses are cameraFromStart; steps are twists ξ (rad, mm): pose ← exp(ξ) pose.
class SourceFreedom {
public:
    /// Allows motion in all six parameters.
    SourceFreedom() = default;

    /// `freedom` refers to cameraFromPatient; `start` and the tree's centroid (patient mm) define the initial position.
    SourceFreedom(const PoseFreedom& freedom, const RigidTransform& start, const Eigen::Vector3d& centroidInPatient);

    bool isFull() const { return freedom_.isFull(); }
    const PoseFreedom& aboutCentroid() const { return freedom_; }
    const Eigen::Vector3d& centroidInStart() const { return centroidInStart_; }

    /// Returns the damped step by core::dampedStep within the allowed motions. With Freedom::Rotation, the tree rotates
    /// about the source as far as locked shifts allow.
    Vector6d dampedStep(const NormalEquations& equations, double damping, const RigidTransform& pose,
                        Freedom freedom = Freedom::Full) const;

    /// Returns the negative gradient, scaled by `weights` and restricted to the allowed motions.
    Vector6d descentDirection(const Vector6d& gradient, const Vector6d& weights, const RigidTransform& pose,
                              Freedom freedom) const;

    /// Returns a pose after a twist; locked parameters keep their exact values.
    RigidTransform retract(const RigidTransform& pose, const Vector6d& twist) const;

private:
    StepBasis freeTwists(const RigidTransform& pose, Freedom freedom) const;

    PoseFreedom freedom_;
    Eigen::Vector3d centroidInStart_ = Eigen::Vector3d::Zero();
};

}   // namespace angiopose::core

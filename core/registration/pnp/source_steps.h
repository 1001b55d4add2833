#pragma once

#include "core/registration/pnp/kernel_distances.h"

namespace angiopose::core {

/// Base for least-squares problems of DampedDescent that rotate the points about the X-ray source: states and steps.
class SourceSteps {
public:
    using State = RigidTransform;
    using Step = Vector6d;
    using Equations = NormalEquations;

    /// `problem` must outlive this object and have at least one point.
    SourceSteps(const KernelProblem& problem, Freedom freedom);

    Vector6d step(const RigidTransform& pose, const NormalEquations& equations, double damping) const;
    RigidTransform retract(const RigidTransform& pose, const Vector6d& step) const;

    /// Returns the length of a step; a rotation counts as the shift that it causes at the depth of the points.
    double lengthMm(const RigidTransform& pose, const Vector6d& step) const;

    /// Returns the depth of the points' centroid.
    double depthMm(const RigidTransform& pose) const { return (pose * centroid_).z(); }

protected:
    const KernelProblem& problem() const { return problem_; }

private:
    const KernelProblem& problem_;
    Freedom freedom_;
    Eigen::Vector3d centroid_;
};

/// Returns the mean of one or more points.
Eigen::Vector3d meanOf(std::span<const Eigen::Vector3d> points);

}   // namespace angiopose::core

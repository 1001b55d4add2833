#pragma once

#include "core/registration/pnp/kernel_distances.h"

namespace angiopose::core {

/// States and steps of descents (see DampedDescent) that rotate the points about the X-ray source.
class SourceSteps {
public:
    using State = RigidTransform;
    using Step = Vector6d;
    using Equations = NormalEquations;

    /// `problem` must outlive this object and have at least one point.
    SourceSteps(const KernelProblem& problem, Freedom freedom);

    Vector6d step(const RigidTransform& pose, const NormalEquations& equations, double damping) const;
    RigidTransform moved(const RigidTransform& pose, const Vector6d& step) const;

    /// Length of a step, with rotation counted as the shift it causes at the depth of the points.
    double lengthMm(const RigidTransform& pose, const Vector6d& step) const;

    /// Depth of the points' centroid.
    double depthMm(const RigidTransform& pose) const { return (pose * centroid_).z(); }

protected:
    const KernelProblem& problem() const { return problem_; }

private:
    const KernelProblem& problem_;
    Freedom freedom_;
    Eigen::Vector3d centroid_;
};

/// Mean of the points; requires at least one.
Eigen::Vector3d meanOf(std::span<const Eigen::Vector3d> points);

}   // namespace angiopose::core

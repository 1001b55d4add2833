#include "core/registration/pnp/source_steps.h"

#include <cassert>
#include <cmath>

namespace angiopose::core {

SourceSteps::SourceSteps(const KernelProblem& problem, Freedom freedom)
    : problem_(problem), freedom_(freedom), centroid_(meanOf(problem.points))
{
}

Vector6d SourceSteps::step(const RigidTransform& pose, const NormalEquations& equations, double damping) const
{
    return problem_.freedom.dampedStep(equations, damping, pose, freedom_);
}

RigidTransform SourceSteps::retract(const RigidTransform& pose, const Vector6d& step) const
{
    return problem_.freedom.retract(pose, step);
}

double SourceSteps::lengthMm(const RigidTransform& pose, const Vector6d& step) const
{
    return std::hypot(depthMm(pose) * step.head<3>().norm(), step.tail<3>().norm());
}

Eigen::Vector3d meanOf(std::span<const Eigen::Vector3d> points)
{
    assert(!points.empty());
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : points) {
        sum += point;
    }
    return sum / static_cast<double>(points.size());
}

}   // namespace angiopose::core

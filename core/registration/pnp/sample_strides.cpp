#include "core/registration/pnp/sample_strides.h"

#include <algorithm>

namespace angiopose::core {
namespace {

/// Returns the stride for samples about `stepPx` apart, given their mean spacing.
std::size_t strideAt(double stepPx, double spacingPx)
{
    return std::max<std::size_t>(1, static_cast<std::size_t>(stepPx / std::max(spacingPx, 1e-6)));
}

double meanSpacingPx(const std::vector<Eigen::Vector2d>& points, const std::vector<int>& curve)
{
    double length = 0.0;
    double count = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (curve[i] == curve[i - 1]) {
            length += (points[i] - points[i - 1]).norm();
            count += 1.0;
        }
    }
    return count > 0.0 ? length / count : 1.0;
}

}   // namespace

std::size_t treeStride(const RegistrationProblem& problem, double stepPx)
{
    std::vector<Eigen::Vector2d> atStart;
    for (const Eigen::Vector3d& point : problem.tree.points) {
        atStart.push_back(project(problem.camera, problem.start * point).value_or(Eigen::Vector2d::Zero()));
    }
    return strideAt(stepPx, meanSpacingPx(atStart, problem.tree.branchIndex));
}

std::size_t targetStride(const TargetSamples& target, double stepPx)
{
    return strideAt(stepPx, meanSpacingPx(target.points, target.curveIndex));
}

}   // namespace angiopose::core

#include "core/registration/pnp/sparse_kernel.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double damping = 1e-3;

/// Converts normal equations for steps about the source to steps about the tree's centroid.
NormalEquations aboutCentroid(const NormalEquations& equations, const Eigen::Vector3d& centroidInCamera)
{
    Matrix6d sourceFromCentroid = Matrix6d::Identity();
    sourceFromCentroid.bottomLeftCorner<3, 3>() = skew(centroidInCamera);
    const Matrix6d hessian = equations.hessian.selfadjointView<Eigen::Lower>();
    return {sourceFromCentroid.transpose() * hessian * sourceFromCentroid,
            sourceFromCentroid.transpose() * equations.gradient};
}

}   // namespace

SparseKernel::SparseKernel(const RegistrationProblem& problem, std::size_t maxPoints)
    : camera_(problem.camera),
      freedom_(problem.freedom),
      target_(problem.target.points, problem.camera.width, problem.camera.height)
{
    const std::size_t stride = std::max<std::size_t>(1, (problem.tree.size() + maxPoints - 1) / maxPoints);
    for (std::size_t i = 0; i < problem.tree.size(); i += stride) {
        points_.emplace_back(problem.tree.points[i] - problem.tree.centroid);
    }
}

double SparseKernel::agreement(const CentroidPose& pose, double scalePx)
{
    measureDistances(problem(), {pose.rotation, pose.centroidInCamera}, distances_);
    return 1.0 - kernelLoss(distances_, scalePx) / static_cast<double>(points_.size());
}

CentroidPose SparseKernel::gaussNewtonStep(const CentroidPose& pose, double scalePx, bool inPlaneOnly)
{
    measureDistances(problem(), {pose.rotation, pose.centroidInCamera}, distances_);
    const NormalEquations equations =
        aboutCentroid(kernelEquations(problem(), distances_, scalePx), pose.centroidInCamera);
    const PoseFreedom freedom =
        inPlaneOnly ? freedom_.withLockedAxes({PoseAxis::LaoRao, PoseAxis::CraCau}, pose) : freedom_;
    return freedom.retract(pose, freedom.dampedStep(equations, damping, pose));
}

}   // namespace angiopose::core

#include "core/registration/judging/pose_shift.h"

#include "core/registration/alignment/alignment_points.h"
#include "core/registration/alignment/graduated_refinement.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr std::size_t usedShiftPoints = 300;
constexpr RefinementSchedule settleSchedule{5.0, 1.0, 0.6, 2, 4, 16};

}   // namespace

double meanShiftMm(const TreeSamples& tree, const RigidTransform& a, const RigidTransform& b)
{
    double sum = 0.0;
    for (const Eigen::Vector3d& point : tree.points) {
        sum += (a * point - b * point).head<2>().norm();
    }
    return sum / static_cast<double>(tree.size());
}

/// Averages the trace of J C Jᵀ over the points, with J = [−[a]× | I] without its last row. It is quadratic in the
/// offset a from the centroid, which makes the first and second moments of these offsets sufficient.
double expectedShiftMm(const RegistrationProblem& problem, const RigidTransform& pose,
                       const PoseUncertainty& uncertainty)
{
    const TreeSamples& tree = problem.tree;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& point : tree.points) {
        const Eigen::Vector3d arm = point - problem.wholeTreeCentroid;
        mean += arm;
        squares += arm * arm.transpose();
    }
    const auto count = static_cast<double>(tree.size());
    const Eigen::Vector3d m = pose.rotation * mean / count;
    const Eigen::Matrix3d s = pose.rotation * squares * pose.rotation.transpose() / count;
    const Matrix6d& c = uncertainty.imageCovariance;
    // The shift in x is ωy az − ωz ay + δx, in y it is ωz ax − ωx az + δy.
    const double x = c(1, 1) * s(2, 2) + c(2, 2) * s(1, 1) - 2.0 * c(1, 2) * s(1, 2) + c(3, 3) +
                     2.0 * (c(1, 3) * m.z() - c(2, 3) * m.y());
    const double y = c(2, 2) * s(0, 0) + c(0, 0) * s(2, 2) - 2.0 * c(0, 2) * s(0, 2) + c(4, 4) +
                     2.0 * (c(2, 4) * m.x() - c(0, 4) * m.z());
    return std::sqrt(std::max(0.0, x + y));
}

double depthShiftMm(const RegistrationProblem& problem, const RigidTransform& cameraFromPatient)
{
    return (cameraFromPatient * problem.tree.centroid).z() - (problem.start * problem.tree.centroid).z();
}

double refinementShiftMm(const RegistrationProblem& problem, const TargetLines& target, const RigidTransform& pose,
                         const RegistrationOptions& options)
{
    const TreeSamples& tree = problem.tree;
    Alignment alignment(alignmentPoints(tree, strideFor(tree.size(), usedShiftPoints)), problem.camera, target);
    const InitialPosePrior prior =
        initialPosePrior(aboutCentroid(problem.start, tree.centroid), options, problem.freedom);
    const RefinementResult settled = refine(alignment, prior, aboutCentroid(pose, tree.centroid), settleSchedule);
    return meanShiftMm(tree, pose, cameraFromPatient(settled.pose, tree.centroid));
}

}   // namespace angiopose::core

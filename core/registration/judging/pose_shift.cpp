#include "core/registration/judging/pose_shift.h"

#include "core/registration/alignment/graduated_refinement.h"

#include <cmath>

namespace core {
namespace {

constexpr std::size_t usedPoints = 300;
constexpr RefinementSchedule settle{5.0, 1.0, 0.6, 2, 4, 16};

}   // namespace

double meanShiftMm(const TreeSamples& tree, const RigidTransform& a, const RigidTransform& b)
{
    double sum = 0.0;
    for (const Eigen::Vector3d& point : tree.points) {
        sum += (a * point - b * point).head<2>().norm();
    }
    return sum / static_cast<double>(tree.size());
}

double expectedShiftMm(const TreeSamples& tree, const RigidTransform& pose, const PoseUncertainty& uncertainty)
{
    double variance = 0.0;
    for (const Eigen::Vector3d& point : tree.points) {
        Eigen::Matrix<double, 2, 6> J;
        J << -skew(pose.rotation * (point - tree.centroid)).topRows<2>(), Eigen::Matrix<double, 2, 3>::Identity();
        variance += (J * uncertainty.covariance * J.transpose()).trace();
    }
    return std::sqrt(variance / static_cast<double>(tree.size()));
}

double settlingShiftMm(const RegistrationProblem& problem, const TargetLines& target, const RigidTransform& pose,
                       const RegistrationOptions& options)
{
    const TreeSamples& tree = problem.tree;
    Alignment alignment(alignmentPoints(tree, strideFor(tree.size(), usedPoints)), problem.camera, target);
    const StartPrior prior = startPrior(aboutCentroid(problem.start, tree.centroid), options);
    const RefinementResult settled = refine(alignment, prior, aboutCentroid(pose, tree.centroid), settle);
    return meanShiftMm(tree, pose, cameraFromPatient(settled.pose, tree.centroid));
}

}   // namespace core

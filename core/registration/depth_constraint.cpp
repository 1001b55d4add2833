#include "core/registration/depth_constraint.h"

#include "core/registration/alignment/alignment_points.h"
#include "core/registration/alignment/graduated_refinement.h"
#include "core/registration/judging/pose_shift.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double stayedMm = 2.0;
constexpr std::size_t heldPoints = 600;
constexpr RefinementSchedule heldSchedule{5.0, 1.0, 0.6, 2, 8, 24};

/// Moves the pose along its ray to the depth of the initial pose.
CentroidPose atDepthOf(const CentroidPose& start, CentroidPose pose)
{
    pose.centroidInCamera *= start.centroidInCamera.z() / pose.centroidInCamera.z();
    return pose;
}

}   // namespace

std::optional<MethodSolution> constrainDepth(const RegistrationProblem& whole, const RegistrationOptions& options,
                                             const MethodSolution& solution, const RegistrationResult& assessed)
{
    const bool stays = std::abs(depthShiftMm(whole, assessed.cameraFromPatient)) < stayedMm;
    if (assessed.uncertainty.observed[5] || whole.freedom.isLocked(PoseAxis::AlongRay) || stays) {
        return {};
    }
    const bool isPart = std::ranges::count(solution.isOpacified, std::uint8_t{1}) > 0;
    const RegistrationProblem part = isPart ? restrictProblem(whole, solution.isOpacified) : RegistrationProblem();
    const RegistrationProblem& problem = isPart ? part : whole;
    const Eigen::Vector3d& centroid = problem.tree.centroid;
    const CentroidPose start = aboutCentroid(problem.start, centroid);
    const CentroidPose there = atDepthOf(start, aboutCentroid(assessed.cameraFromPatient, centroid));
    const PoseFreedom freedom = problem.freedom.withLockedAxes({PoseAxis::AlongRay}, there);
    Alignment alignment(alignmentPoints(problem.tree, strideFor(problem.tree.size(), heldPoints)), problem.camera,
                        *solution.targetLines);
    MethodSolution held = solution;
    held.cameraFromPatient = cameraFromPatient(
        refine(alignment, initialPosePrior(start, options, freedom), there, heldSchedule).pose, centroid);
    held.agreement.reset();
    return held;
}

}   // namespace angiopose::core

#include "core/registration/methods/methods.h"

#include "core/messages/messages.h"
#include "core/registration/methods/pose_trials.h"
#include "core/registration/pnp/pair_deformation.h"
#include "core/registration/pose/minimize.h"
#include "core/registration/pose/pose_parameters.h"
#include "core/support/stopwatch.h"

#include <algorithm>
#include <limits>

namespace angiopose::core {
namespace {

constexpr double branchReachDecay = 0.8;
constexpr double shortestBranchReachPx = 5.0;
constexpr int evaluationsPerFit = 60;
constexpr int typicalEvaluations = 15;   // evaluations per round, estimated for the progress display
constexpr std::size_t minBranchPairs = 6;
constexpr double settledBranchesMm = 1e-3;

/// Returns the mean squared distance of the pairs, px², and its gradient with respect to pose steps.
double pairCost(const RegistrationProblem& problem, const std::vector<BranchPair>& pairs, const CentroidPose& pose,
                Vector6d& gradient)
{
    gradient.setZero();
    double sum = 0.0;
    for (const BranchPair& pair : pairs) {
        const Eigen::Vector3d arm = pose.rotation * (problem.tree.points[pair.point] - problem.tree.centroid);
        const auto pixel = project(problem.camera, arm + pose.centroidInCamera);
        if (!pixel) {
            return std::numeric_limits<double>::infinity();
        }
        const Eigen::Vector2d gap = *pixel - pair.pixel;
        const Eigen::Vector3d byPoint =
            2.0 * projectionJacobian(problem.camera, arm + pose.centroidInCamera).transpose() * gap;
        sum += gap.squaredNorm();
        gradient.head<3>() += arm.cross(byPoint);
        gradient.tail<3>() += byPoint;
    }
    const auto count = static_cast<double>(pairs.size());
    gradient /= count;
    return sum / count;
}

/// Finds the pose that best aligns the pairs by L-BFGS over Euler angles and shift, and stores it in `search`.
void fitToPairs(const RegistrationProblem& problem, const std::vector<BranchPair>& pairs, PoseTrials& search)
{
    MinimizeOptions lbfgs;
    lbfgs.minimizer = Minimizer::Lbfgs;
    lbfgs.tolerance = 1e-6;
    lbfgs.relativeTolerance = 1e-10;
    lbfgs.maxEvaluations = evaluationsPerFit;
    const PoseParameters parameters(search.best(), metricUnits(problem.tree.spreadMm), problem.freedom);
    const auto cost = [&](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
        const CentroidPose pose = parameters.pose(x);
        Vector6d stepGradient;
        const double meanSquare = pairCost(problem, pairs, pose, stepGradient);
        gradient = parameters.gradient(x, stepGradient);
        return search.recordTrial(pose, meanSquare);
    };
    minimize(cost, parameters.origin(), lbfgs, [&] { return search.isStopped(); });
}

Message displacementMessage(const PairDeformation& deformation)
{
    return messages::matchedBranchesMoved(inMm(deformation.rmsMm, 2), inMm(deformation.maxMotionMm, 2),
                                          Quantity{deformation.medianPx, 2, "px"},
                                          Quantity{deformation.medianBeforePx, 2, "px"})
        .as(Severity::Note);
}

/// Deforms the tree to fit the matched curves, starting from the rigid pose, and returns messages that describe the
/// motion; none if stopped or if nothing moves.
Messages deformOntoCurves(const RegistrationProblem& problem, const BranchMatcher& matching, double reachPx,
                          PoseTrials& search)
{
    const auto isStopped = [&] {
        search.advanceProgress();
        return search.isStopped();
    };
    const PairDeformation deformation =
        deformOntoPairs(problem, matching.tree(), search.best(), matching.pairs(search.best(), reachPx), isStopped);
    return deformation.maxMotionMm > 0.0 && !search.isStopped() ? Messages{displacementMessage(deformation)}
                                                                : Messages();
}

}   // namespace

MethodSolution solveMatchedBranches(const RegistrationProblem& problem, const RegistrationOptions& options,
                                    ProgressLog& progress)
{
    Stopwatch stopwatch;
    const BranchMatcher matching(problem);
    const double targetMs = stopwatch.takeLapMs();
    PoseTrials search(problem, typicalEvaluations * options.branches.rounds + deformationEvaluations, progress);
    StopReason reason = StopReason::IterationLimit;
    double reachPx = std::max(options.branches.reachPx, shortestBranchReachPx);
    for (int round = 0; round < options.branches.rounds && !search.isStopped(); ++round) {
        const CentroidPose before = search.best();
        const std::vector<BranchPair> pairs = matching.pairs(before, reachPx);
        search.advanceProgress();
        if (pairs.size() < minBranchPairs) {
            reason = StopReason::NoImprovement;
            break;
        }
        search.startStage("branches", reachPx, std::numeric_limits<double>::infinity());
        fitToPairs(problem, pairs, search);
        const double motionMm = stepLengthMm(stepBetween(before, search.best()), problem.tree.spreadMm);
        if (reachPx <= shortestBranchReachPx && motionMm < settledBranchesMm) {
            reason = StopReason::Converged;
            break;
        }
        reachPx = std::max(shortestBranchReachPx, branchReachDecay * reachPx);
    }
    Messages notes;
    if (options.branches.motion && !search.isStopped()) {
        notes = deformOntoCurves(problem, matching, reachPx, search);
    }
    MethodSolution solution = search.solution(reason);
    solution.warnings = std::move(notes);
    solution.time.targetMs = targetMs;
    solution.time.solveMs = stopwatch.takeLapMs();
    return solution;
}

}   // namespace angiopose::core

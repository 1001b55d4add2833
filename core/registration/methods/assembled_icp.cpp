#include "core/registration/methods/methods.h"

#include "core/registration/pnp/alternating_search.h"
#include "core/registration/pose/sqpnp.h"
#include "core/support/stopwatch.h"

#include <algorithm>

namespace angiopose::core {
namespace {

/// Whether two point lists are equal up to rounding.
bool areSame(const std::vector<Eigen::Vector2d>& a, const std::vector<Eigen::Vector2d>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto& p, const auto& q) { return (p - q).squaredNorm() < 1e-12; });
}

/// Alternates matching and PnP. The solver takes no initial pose and therefore cannot solve for the rotation alone.
class RepeatedPnp final : public PointSolver {
public:
    explicit RepeatedPnp(int maxIterations) : maxIterations_(maxIterations) {}

    KernelPnpResult solve(const KernelProblem& problem, SearchStage stage, const RigidTransform& start,
                          const KernelObserver& observe) override;
    int maxIterations(SearchStage stage) const override { return stage == SearchStage::Auxiliary ? 1 : maxIterations_; }
    bool canSolveRotation() const override { return false; }

private:
    /// Collects pairs for all points that project, at the pose last measured.
    void collectPairs(const KernelProblem& problem);

    int maxIterations_;
    KernelDistances distances_;
    std::vector<Eigen::Vector3d> points_;
    std::vector<Eigen::Vector2d> partnersPx_;
};

void RepeatedPnp::collectPairs(const KernelProblem& problem)
{
    points_.clear();
    partnersPx_.clear();
    for (std::size_t i = 0; i < problem.points.size(); ++i) {
        if (const auto pixel = project(problem.camera, distances_.inCamera[i])) {
            points_.push_back(problem.points[i]);
            partnersPx_.emplace_back(*pixel - distances_.residualPx[i]);
        }
    }
}

KernelPnpResult RepeatedPnp::solve(const KernelProblem& problem, SearchStage stage, const RigidTransform& start,
                                   const KernelObserver& observe)
{
    KernelPnpResult result;
    result.pose = start;
    result.stopReason = StopReason::IterationLimit;
    std::vector<Eigen::Vector2d> before;
    measureDistances(problem, result.pose, distances_);
    while (result.iterations < maxIterations(stage)) {
        before.swap(partnersPx_);
        collectPairs(problem);
        if (result.iterations > 0 && areSame(before, partnersPx_)) {
            result.stopReason = StopReason::Converged;
            break;
        }
        const std::optional<RigidTransform> pose = solveSqpnp(points_, partnersPx_, problem.camera);
        if (!pose) {
            result.stopReason = StopReason::NoImprovement;
            break;
        }
        result.pose = *pose;
        measureDistances(problem, result.pose, distances_);
        ++result.iterations;
        if (observe && observe({result.iterations, 0.0, result.pose, &distances_}) == ObserverDecision::Stop) {
            result.stopReason = StopReason::StoppedByUser;
            break;
        }
    }
    return result;
}

}   // namespace

MethodSolution solveAssembledIcp(const RegistrationProblem& problem, const RegistrationOptions& options,
                                 ProgressLog& progress)
{
    Stopwatch stopwatch;
    const SeedProblem seed = makeSeedProblem(problem, options);
    const double targetMs = stopwatch.takeLapMs();
    RepeatedPnp solver(options.icp.iterations);
    MethodSolution solution =
        searchAlternating(problem, options, seed, solver, {false, options.icp.alternate}, progress);
    solution.time.targetMs = targetMs;
    return solution;
}

}   // namespace angiopose::core

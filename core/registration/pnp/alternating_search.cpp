#include "core/registration/pnp/alternating_search.h"

#include "core/support/stopwatch.h"

#include <cmath>
#include <optional>

namespace angiopose::core {
namespace {

constexpr int maxRounds = 5;
constexpr double goodEnoughPx = 1.0;   // median distance ξ that ends the search (decision 3)
constexpr double sameShare = 0.001;   // relative change of the median distance that counts as none (decision 1)

// Fractions of the progress: rotation of the total, auxiliary problem of each round.
constexpr double turnShare = 0.2;
constexpr double auxiliaryShareOfRound = 1.0 / 3.0;

struct Stage {
    SearchStage kind = SearchStage::Full;
    std::string_view name;
    double progressFrom = 0.0;
    double progressTo = 0.0;
};

/// Runs the search with one function per step of the paper. Poses are motions cameraFromStart.
class AlternatingSearch {
public:
    AlternatingSearch(const RegistrationProblem& problem, const SeedProblem& seed, PointSolver& solver,
                      double finalScalePx, ProgressLog& progress)
        : problem_(problem),
          seed_(seed),
          solver_(solver),
          finalScalePx_(finalScalePx),
          progress_(progress),
          full_(seed.full(problem.camera))
    {
    }

    MethodSolution run(Alternation alternation);

private:
    void turnAboutSource(const Stage& stage);
    void solveAuxiliary(const Stage& stage);
    StopReason solveFull(const Stage& stage);
    std::optional<StopReason> checkTermination();

    ObserverDecision reportStep(const Stage& stage, const KernelIteration& step);
    void keepIfBest(const KernelIteration& step);

    const RegistrationProblem& problem_;
    const SeedProblem& seed_;
    PointSolver& solver_;
    double finalScalePx_;
    ProgressLog& progress_;
    KernelProblem full_;
    RigidTransform pose_;   ///< current pose of the search
    RigidTransform
        best_;   ///< by E_data at the final ℓ; until the end of the first round, the latest pose of the full problem
    std::optional<double> bestLoss_;
    std::optional<double> lastMedianPx_;   ///< median distance after the previous round
    KernelDistances distances_;
    std::vector<double> scratch_;
};

MethodSolution AlternatingSearch::run(Alternation alternation)
{
    MethodSolution solution;
    const bool turns = alternation.rotatesFirst && solver_.canSolveRotation();
    if (turns) {
        turnAboutSource({SearchStage::Turn, "rotation", 0.0, turnShare});
    }
    const bool hasAuxiliary = alternation.alternates && determinesPose(seed_.auxiliary, seed_.points);
    const double begin = turns ? turnShare : 0.0;
    const double roundShare = (1.0 - begin) / (alternation.alternates ? maxRounds : 1);
    for (int round = 0; round < maxRounds && !progress_.isStopped(); ++round) {
        const double from = begin + round * roundShare;
        const double fullFrom = from + (hasAuxiliary ? auxiliaryShareOfRound * roundShare : 0.0);
        if (hasAuxiliary) {
            solveAuxiliary({SearchStage::Auxiliary, "auxiliary", from, fullFrom});
        }
        if (progress_.isStopped()) {
            break;
        }
        const StopReason ofFullProblem = solveFull({SearchStage::Full, "refine", fullFrom, from + roundShare});
        const std::optional<StopReason> ofLoop = checkTermination();
        if (!alternation.alternates || ofLoop) {
            solution.stopReason = alternation.alternates ? *ofLoop : ofFullProblem;
            break;
        }
    }
    if (progress_.isStopped()) {
        solution.stopReason = StopReason::StoppedByUser;
    }
    solution.cameraFromPatient = best_ * problem_.start;
    solution.iterations = progress_.iterations();
    return solution;
}

/// Step 0: rotates the tree about the source, whose position stays fixed (decision 4).
void AlternatingSearch::turnAboutSource(const Stage& stage)
{
    const auto observe = [&](const KernelIteration& step) {
        keepIfBest(step);
        return reportStep(stage, step);
    };
    pose_ = solver_.solve(full_, SearchStage::Turn, pose_, observe).pose;
}

/// Step A: solves for {p'} with fixed current matches, which pushes the pose out of local optima of the full point set.
void AlternatingSearch::solveAuxiliary(const Stage& stage)
{
    std::vector<Eigen::Vector3d> points;
    std::vector<Eigen::Vector2d> matchesPx;
    for (const Eigen::Vector3d& point : seed_.auxiliary) {
        if (const auto pixel = project(problem_.camera, pose_ * point)) {
            points.push_back(point);
            matchesPx.push_back(seed_.target->nearest(*pixel));
        }
    }
    if (!determinesPose(points, seed_.points)) {
        return;
    }
    KernelProblem held{points, problem_.camera, seed_.target.get(), matchesPx};
    held.freedom = seed_.freedom;
    const auto observe = [&](const KernelIteration& step) { return reportStep(stage, step); };
    pose_ = solver_.solve(held, SearchStage::Auxiliary, pose_, observe).pose;
}

/// Step B: solves for all points with updated matches.
StopReason AlternatingSearch::solveFull(const Stage& stage)
{
    const KernelPnpResult result = solver_.solve(full_, SearchStage::Full, pose_, [&](const KernelIteration& step) {
        keepIfBest(step);
        return reportStep(stage, step);
    });
    pose_ = result.pose;
    return result.stopReason;
}

/// Decision 1: returns the reason to end the loop, if any. A worse round does not end the loop, because the matches
/// fixed at the new pose often push the pose out of the local optimum in the next round. A round that ends where the
/// previous one did ends the loop, because the next one would repeat it.
std::optional<StopReason> AlternatingSearch::checkTermination()
{
    measureDistances(full_, pose_, distances_);
    keepIfBest({0, 0.0, pose_, &distances_});
    bestLoss_ = bestLoss_.value_or(kernelLoss(distances_, finalScalePx_));
    const double medianPx = medianDistancePx(distances_, scratch_);
    if (medianPx < goodEnoughPx) {
        return StopReason::Converged;
    }
    if (lastMedianPx_ && std::abs(medianPx - *lastMedianPx_) <= sameShare * *lastMedianPx_) {
        return StopReason::NoImprovement;
    }
    lastMedianPx_ = medianPx;
    return std::nullopt;
}

ObserverDecision AlternatingSearch::reportStep(const Stage& stage, const KernelIteration& step)
{
    const double done = static_cast<double>(step.iteration) / solver_.maxIterations(stage.kind);
    IterationReport report;
    report.stage = stage.name;
    report.progress = stage.progressFrom + (stage.progressTo - stage.progressFrom) * done;
    report.scalePx = step.scalePx;
    report.medianDistancePx = medianDistancePx(*step.distances, scratch_);
    report.cameraFromPatient = best_ * problem_.start;
    return progress_.report(report);
}

/// Keeps the pose if it is the best so far. Only poses measured with all points and their nearest matches compete.
void AlternatingSearch::keepIfBest(const KernelIteration& step)
{
    if (bestLoss_) {
        const double loss = kernelLoss(*step.distances, finalScalePx_);
        if (loss >= *bestLoss_) {
            return;
        }
        bestLoss_ = loss;
    }
    best_ = step.pose;
}

}   // namespace

MethodSolution searchAlternating(const RegistrationProblem& problem, const RegistrationOptions& options,
                                 const SeedProblem& seed, PointSolver& solver, Alternation alternation,
                                 ProgressLog& progress)
{
    Stopwatch stopwatch;
    MethodSolution solution = AlternatingSearch(problem, seed, solver, options.finalScalePx, progress).run(alternation);
    solution.time.solveMs = stopwatch.takeLapMs();
    return solution;
}

}   // namespace angiopose::core

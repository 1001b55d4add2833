#include "core/registration/methods/dynaweight.h"

#include "core/registration/seed_problem.h"
#include "core/support/stopwatch.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace core {
namespace {

constexpr int turnIterations = 40;
constexpr int auxiliaryIterations = 20;
constexpr int fullIterations = 40;
constexpr int maxRounds = 5;
constexpr double goodEnoughPx = 1.0;   // ξ, decision 3
constexpr double stalledRatio = 0.999;   // decision 1

// Shares of the progress: the turn, then each round's auxiliary and full problem.
constexpr double turnShare = 0.2;
constexpr double roundShare = (1.0 - turnShare) / maxRounds;
constexpr double auxiliaryShare = roundShare / 3.0;

struct Stage {
    std::string_view name;
    double progressFrom = 0.0;
    double progressTo = 0.0;
};

/// The alternating search, a step of the paper per function. Poses are cameraFromStart.
class AlternatingSearch {
public:
    AlternatingSearch(const RegistrationProblem& problem, const RegistrationOptions& options, ProgressLog& progress)
        : problem_(problem),
          options_(options),
          progress_(progress),
          seed_(makeSeedProblem(problem, options)),
          full_{seed_.points, problem.camera, seed_.target.get(), {}}
    {
    }

    MethodSolution run();

private:
    void turnAboutSource(const Stage& stage);
    void solveAuxiliary(const Stage& stage);
    StopReason solveFull(const Stage& stage);
    std::optional<StopReason> closeRound();

    KernelSchedule scheduleWithoutPrior(int maxIterations) const;
    Verdict reportStep(const Stage& stage, const KernelIteration& step, int maxIterations);
    void keepIfBest(const KernelIteration& step);

    const RegistrationProblem& problem_;
    const RegistrationOptions& options_;
    ProgressLog& progress_;
    SeedProblem seed_;
    KernelProblem full_;
    RigidTransform pose_;   ///< where the search stands
    RigidTransform best_;   ///< by E_data at the final ℓ; until the first round ends, the latest of the full problem
    std::optional<double> bestLoss_;
    double lastMedianPx_ = std::numeric_limits<double>::infinity();
    KernelDistances distances_;
    std::vector<double> scratch_;
};

MethodSolution AlternatingSearch::run()
{
    MethodSolution solution;
    if (options_.rotationFirst != 0.0) {
        turnAboutSource({"rotation", 0.0, turnShare});
    }
    const bool alternates = options_.alternation != 0.0;
    const bool hasAuxiliary = alternates && isSolvableAlone(seed_.auxiliary, seed_.points);
    for (int round = 0; round < maxRounds && !progress_.isStopped(); ++round) {
        const double start = turnShare + round * roundShare;
        if (hasAuxiliary) {
            solveAuxiliary({"auxiliary", start, start + auxiliaryShare});
        }
        if (progress_.isStopped()) {
            break;
        }
        const StopReason ofFullProblem = solveFull({"refine", start + auxiliaryShare, start + roundShare});
        const std::optional<StopReason> ofLoop = closeRound();
        if (!alternates || ofLoop) {
            solution.stopReason = alternates ? *ofLoop : ofFullProblem;
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

/// Step 0: rotation-only kernel PnP; the shift of the source stays (decision 4).
void AlternatingSearch::turnAboutSource(const Stage& stage)
{
    KernelSchedule schedule = scheduleWithoutPrior(turnIterations);
    schedule.freedom = Freedom::Rotation;
    KernelPnp solver(full_, {}, schedule);
    pose_ = solver
                .solve(pose_,
                       [&](const KernelIteration& step) {
                           keepIfBest(step);
                           return reportStep(stage, step, schedule.maxIterations);
                       })
                .pose;
}

/// Step A: {p'} with the matches it has now, held. Held matches push the pose out of a local optimum of the full set.
void AlternatingSearch::solveAuxiliary(const Stage& stage)
{
    std::vector<Eigen::Vector3d> points;
    std::vector<Eigen::Vector2d> partnersPx;
    for (const Eigen::Vector3d& point : seed_.auxiliary) {
        if (const auto pixel = project(problem_.camera, pose_ * point)) {
            points.push_back(point);
            partnersPx.push_back(seed_.target->nearest(*pixel));
        }
    }
    if (!isSolvableAlone(points, seed_.points)) {
        return;
    }
    const KernelSchedule schedule = scheduleWithoutPrior(auxiliaryIterations);
    KernelPnp solver({points, problem_.camera, seed_.target.get(), partnersPx}, {}, schedule);
    pose_ =
        solver
            .solve(pose_, [&](const KernelIteration& step) { return reportStep(stage, step, schedule.maxIterations); })
            .pose;
}

/// Step B: all points with fresh matches, under the prior of the preset.
StopReason AlternatingSearch::solveFull(const Stage& stage)
{
    KernelSchedule schedule = seed_.schedule;
    schedule.maxIterations = std::min(schedule.maxIterations, fullIterations);
    KernelPnp solver(full_, seed_.prior, schedule);
    const KernelPnpResult result = solver.solve(pose_, [&](const KernelIteration& step) {
        keepIfBest(step);
        return reportStep(stage, step, schedule.maxIterations);
    });
    pose_ = result.pose;
    return result.stopReason;
}

/// Decision 1: why the loop ends here, if it does.
std::optional<StopReason> AlternatingSearch::closeRound()
{
    measure(full_, pose_, distances_);
    keepIfBest({0, 0.0, pose_, &distances_});
    bestLoss_ = bestLoss_.value_or(kernelLoss(distances_, options_.finalScalePx));
    const double medianPx = medianDistancePx(distances_, scratch_);
    if (medianPx < goodEnoughPx) {
        return StopReason::Converged;
    }
    if (medianPx > stalledRatio * lastMedianPx_) {
        return StopReason::NoImprovement;
    }
    lastMedianPx_ = medianPx;
    return std::nullopt;
}

KernelSchedule AlternatingSearch::scheduleWithoutPrior(int maxIterations) const
{
    KernelSchedule schedule = seed_.schedule;
    schedule.maxIterations = std::min(schedule.maxIterations, maxIterations);
    schedule.nearestMm = seed_.nearestMm;
    schedule.farthestMm = seed_.farthestMm;
    return schedule;
}

Verdict AlternatingSearch::reportStep(const Stage& stage, const KernelIteration& step, int maxIterations)
{
    IterationReport report;
    report.stage = stage.name;
    report.progress = stage.progressFrom + (stage.progressTo - stage.progressFrom) * step.iteration / maxIterations;
    report.scalePx = step.scalePx;
    report.medianDistancePx = medianDistancePx(*step.distances, scratch_);
    report.cameraFromPatient = best_ * problem_.start;
    return progress_.report(report);
}

/// Only poses measured with all points compete.
void AlternatingSearch::keepIfBest(const KernelIteration& step)
{
    if (bestLoss_) {
        const double loss = kernelLoss(*step.distances, options_.finalScalePx);
        if (loss >= *bestLoss_) {
            return;
        }
        bestLoss_ = loss;
    }
    best_ = step.pose;
}

}   // namespace

MethodSolution solveDynaWeight(const RegistrationProblem& problem, const RegistrationOptions& options,
                               ProgressLog& progress)
{
    Stopwatch stopwatch;
    AlternatingSearch search(problem, options, progress);
    const double targetMs = stopwatch.lapMs();
    MethodSolution solution = search.run();
    solution.time.targetMs = targetMs;
    solution.time.solveMs = stopwatch.lapMs();
    return solution;
}

}   // namespace core

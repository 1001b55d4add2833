#include "core/registration/methods/angiopose.h"

#include "core/registration/agreement_score.h"
#include "core/registration/coarse_search.h"
#include "core/registration/graduated_refinement.h"
#include "core/registration/pose_uncertainty.h"
#include "core/registration/shape_tolerance.h"
#include "core/support/stopwatch.h"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

constexpr std::size_t searchPoints = 100;
constexpr std::size_t roughPoints = 300;
constexpr std::size_t finalists = 3;
constexpr double nearlyAsGood = 0.95;   // ALGORITHMS §6.10
constexpr double distinctSigmas = 3.0;

constexpr RefinementSchedule roughSchedule{14.0, 2.5, 0.7, 2, 0, 40};

struct ScoredPose {
    CentroidPose pose;
    double score = 0.0;
    double scalePx = 0.0;
    StopReason stopReason = StopReason::Converged;
};

std::size_t strideFor(std::size_t count, std::size_t wanted)
{
    return std::max<std::size_t>(1, count / wanted);
}

/// One registration: target built once, then hypotheses → finalists → winner.
class AngioPose {
public:
    AngioPose(const RegistrationProblem& problem, const RegistrationOptions& options, ProgressLog& progress)
        : problem_(problem),
          options_(options),
          progress_(progress),
          target_(problem.target, problem.camera),
          start_(aboutCentroid(problem.start, problem.tree.centroid)),
          prior_(startPrior(start_, options)),
          rough_(alignmentPoints(problem.tree, strideFor(problem.tree.size(), roughPoints)), problem.camera, target_),
          full_(alignmentPoints(problem.tree), problem.camera, target_),
          score_(problem.tree, problem.camera, target_)
    {
    }

    std::vector<CentroidPose> hypotheses();
    std::vector<ScoredPose> refineRoughly(const std::vector<CentroidPose>& hypotheses);
    std::vector<ScoredPose> refineFinalists(const std::vector<ScoredPose>& ranked);
    std::vector<Hypothesis> alternativesTo(const std::vector<ScoredPose>& ranked) const;

    RigidTransform inPatient(const CentroidPose& pose) const { return cameraFromPatient(pose, problem_.tree.centroid); }

private:
    std::vector<CoarseCandidate> search(const std::vector<AlignmentPoint>& points);
    Verdict report(std::string_view stage, double progress, const CentroidPose& pose, double scalePx);

    const RegistrationProblem& problem_;
    const RegistrationOptions& options_;
    ProgressLog& progress_;
    TargetLines target_;
    CentroidPose start_;
    StartPrior prior_;
    Alignment rough_;
    Alignment full_;
    AgreementScore score_;
    CentroidPose best_ = start_;
    std::vector<double> residuals_;
};

Verdict AngioPose::report(std::string_view stage, double progress, const CentroidPose& pose, double scalePx)
{
    IterationReport report;
    report.stage = stage;
    report.progress = progress;
    report.scalePx = scalePx;
    report.medianDistancePx = rough_.medianDistancePx(pose, residuals_);
    report.cameraFromPatient = inPatient(pose);
    return progress_.report(report);
}

std::vector<CoarseCandidate> AngioPose::search(const std::vector<AlignmentPoint>& points)
{
    const CoarseSearch search(problem_.camera, target_);
    return search.find(points, start_, {options_.searchRadiusMm, options_.searchTiltDeg, options_.searchRollDeg},
                       [&](double) { return Verdict::Continue; });
}

std::vector<CentroidPose> AngioPose::hypotheses()
{
    std::vector<CentroidPose> result{start_};
    if (options_.search != 0.0) {
        const auto found = search(alignmentPoints(problem_.tree, strideFor(problem_.tree.size(), searchPoints)));
        for (const CoarseCandidate& candidate : found) {
            result.push_back(candidate.pose);
        }
    }
    return result;
}

std::vector<ScoredPose> AngioPose::refineRoughly(const std::vector<CentroidPose>& hypotheses)
{
    std::vector<ScoredPose> ranked;
    double bestScore = -1.0;
    for (const CentroidPose& hypothesis : hypotheses) {
        rough_.resetVisibility();
        const RefinementResult refined = refine(rough_, prior_, hypothesis, roughSchedule);
        ranked.push_back({refined.pose, score_.of(refined.pose), refined.scalePx, refined.stopReason});
        if (ranked.back().score > bestScore) {
            bestScore = ranked.back().score;
            best_ = refined.pose;
        }
        const double done = static_cast<double>(ranked.size()) / static_cast<double>(hypotheses.size());
        if (report("refine", 0.3 + 0.4 * done, best_, refined.scalePx) == Verdict::Stop) {
            break;
        }
    }
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const ScoredPose& a, const ScoredPose& b) { return a.score > b.score; });
    return ranked;
}

std::vector<ScoredPose> AngioPose::refineFinalists(const std::vector<ScoredPose>& ranked)
{
    std::vector<ScoredPose> refined;
    RefinementSchedule schedule{4.0, options_.finalScalePx, 0.7, 2, 20, options_.maxIterations};
    for (const ScoredPose& candidate : ranked) {
        if (refined.size() == finalists || progress_.isStopped()) {
            break;
        }
        const auto isSame = [&](const ScoredPose& other) {
            const Vector6d step = stepBetween(candidate.pose, other.pose);
            return step.head<3>().norm() < 0.02 && step.tail<3>().head<2>().norm() < 3.0;
        };
        if (std::any_of(refined.begin(), refined.end(), isSame)) {
            continue;
        }
        full_.resetVisibility();
        const RefinementResult result =
            refine(full_, prior_, candidate.pose, schedule, [&](const RefinementStep& step) {
                return report("refine", 0.7 + 0.1 * (static_cast<double>(refined.size()) + step.progress),
                              refined.empty() ? step.pose : refined.front().pose, step.scalePx);
            });
        const CentroidPose pose = refineTolerantly(full_, prior_, result.pose, result.scalePx);
        refined.push_back({pose, score_.of(pose), result.scalePx, result.stopReason});
    }
    std::stable_sort(refined.begin(), refined.end(),
                     [](const ScoredPose& a, const ScoredPose& b) { return a.score > b.score; });
    return refined;
}

std::vector<Hypothesis> AngioPose::alternativesTo(const std::vector<ScoredPose>& ranked) const
{
    std::vector<Hypothesis> alternatives;
    const ScoredPose& best = ranked.front();
    if (ranked.size() < 2) {
        return alternatives;
    }
    const Matrix6d information = poseUncertainty(problem_, target_, inPatient(best.pose), prior_).covariance.inverse();
    for (std::size_t k = 1; k < ranked.size(); ++k) {
        const Vector6d step = stepBetween(best.pose, ranked[k].pose);
        if (ranked[k].score >= nearlyAsGood * best.score &&
            step.dot(information * step) > distinctSigmas * distinctSigmas) {
            alternatives.push_back({inPatient(ranked[k].pose), ranked[k].score});
        }
    }
    return alternatives;
}

}   // namespace

MethodSolution solveAngioPose(const RegistrationProblem& problem, const RegistrationOptions& options,
                              ProgressLog& progress)
{
    MethodSolution solution;
    Stopwatch stopwatch;
    AngioPose run(problem, options, progress);
    solution.time.targetMs = stopwatch.lapMs();
    const std::vector<CentroidPose> hypotheses = run.hypotheses();
    solution.time.searchMs = stopwatch.lapMs();
    const std::vector<ScoredPose> ranked = run.refineRoughly(hypotheses);
    solution.time.searchMs += stopwatch.lapMs();
    const std::vector<ScoredPose> finalists = run.refineFinalists(ranked);

    const std::vector<ScoredPose>& best = finalists.empty() ? ranked : finalists;
    solution.cameraFromPatient = run.inPatient(best.front().pose);
    solution.stopReason = progress.isStopped() ? StopReason::StoppedByUser : best.front().stopReason;
    solution.iterations = progress.iterations();
    solution.alternatives = run.alternativesTo(best);
    solution.time.solveMs = stopwatch.lapMs();
    return solution;
}

}   // namespace core

#include "core/registration/methods/angiopose.h"

#include "core/registration/agreement_score.h"
#include "core/registration/coarse_search.h"
#include "core/registration/exact_partners.h"
#include "core/registration/graduated_refinement.h"
#include "core/registration/pose_uncertainty.h"
#include "core/registration/shape_tolerance.h"
#include "core/support/stopwatch.h"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

constexpr std::size_t searchPoints = 90;
constexpr std::size_t roughPoints = 200;
constexpr std::size_t finalists = 3;
constexpr std::size_t auxiliaryCandidates = 4;
constexpr double conclusive = 0.85;   // tree and traced vessels explain each other: no search could do better
constexpr double lost = 0.5;   // below, the tree lies on next to nothing within reach
constexpr double worthRefining = 0.85;   // of the best rough score
constexpr double nearlyAsGood = 0.95;   // ALGORITHMS §6.10
constexpr double distinctSigmas = 3.0;
constexpr double sameTurn = 0.02;
constexpr double sameShiftMm = 3.0;

constexpr RefinementSchedule roughSchedule{14.0, 2.5, 0.6, 2, 0, 40};
constexpr RefinementSchedule middleSchedule{2.5, 1.0, 0.7, 2, 2, 20};

// Shares of the progress bar.
constexpr double searchEnds = 0.4;
constexpr double roughEnds = 0.8;

struct ScoredPose {
    CentroidPose pose;
    double score = 0.0;
    StopReason stopReason = StopReason::Converged;
};

bool isBetter(const ScoredPose& a, const ScoredPose& b)
{
    return a.score > b.score;
}

std::size_t strideFor(std::size_t count, std::size_t wanted)
{
    return std::max<std::size_t>(1, (count + wanted - 1) / wanted);
}

/// One registration under way: hypotheses → rough poses, ranked → finalists → winner.
class AngioPose {
public:
    AngioPose(const RegistrationProblem& problem, const RegistrationOptions& options, ProgressLog& progress);

    /// Rough pose from the start; enough when it is conclusive.
    void tryStart();
    bool isConclusive() const { return !ranked_.empty() && ranked_.front().score >= conclusive; }

    std::vector<CentroidPose> searchHypotheses();
    bool isLost() const { return !ranked_.empty() && ranked_.front().score < lost; }
    std::vector<CentroidPose> recentredHypotheses();
    std::vector<CentroidPose> auxiliaryHypotheses();
    void refineRoughly(const std::vector<CentroidPose>& hypotheses);
    void refineFinalists();

    bool hasPose() const { return !ranked_.empty(); }
    const ScoredPose& best() const { return ranked_.front(); }
    std::vector<Hypothesis> alternatives() const;
    RigidTransform inPatient(const CentroidPose& pose) const { return cameraFromPatient(pose, problem_.tree.centroid); }
    std::shared_ptr<const TargetLines> target() const { return target_; }

private:
    struct SearchPlan {
        CentroidPose start;
        double progressFrom;
        double progressTo;
    };
    std::vector<CentroidPose> search(const std::vector<AlignmentPoint>& points, const SearchPlan& plan);
    void rank(const CentroidPose& hypothesis);
    ScoredPose refineFully(const CentroidPose& pose);
    bool isStopped() const { return progress_.isStopped(); }
    Verdict report(std::string_view stage, double progress, double scalePx);

    const RegistrationProblem& problem_;
    const RegistrationOptions& options_;
    ProgressLog& progress_;
    std::shared_ptr<const TargetLines> target_;
    CentroidPose start_;
    StartPrior prior_;
    Alignment rough_;
    Alignment full_;
    Alignment auxiliary_;
    AgreementScore score_;
    std::vector<ScoredPose> ranked_;   ///< best first
    std::vector<double> distances_;
};

AngioPose::AngioPose(const RegistrationProblem& problem, const RegistrationOptions& options, ProgressLog& progress)
    : problem_(problem),
      options_(options),
      progress_(progress),
      target_(std::make_shared<const TargetLines>(problem.target, problem.camera)),
      start_(aboutCentroid(problem.start, problem.tree.centroid)),
      prior_(startPrior(start_, options)),
      rough_(alignmentPoints(problem.tree, strideFor(problem.tree.size(), roughPoints)), problem.camera, *target_),
      full_(alignmentPoints(problem.tree), problem.camera, *target_),
      auxiliary_(alignmentPoints(problem.tree, problem.auxiliary), problem.camera, *target_),
      score_(problem, *target_)
{
}

/// Always of the best pose so far.
Verdict AngioPose::report(std::string_view stage, double progress, double scalePx)
{
    const CentroidPose& pose = ranked_.empty() ? start_ : best().pose;
    IterationReport report;
    report.stage = stage;
    report.progress = progress;
    report.scalePx = scalePx;
    report.medianDistancePx = rough_.medianDistancePx(pose, distances_);
    report.cameraFromPatient = inPatient(pose);
    return progress_.report(report);
}

void AngioPose::rank(const CentroidPose& hypothesis)
{
    rough_.resetVisibility();
    const RefinementResult refined = refine(rough_, prior_, hypothesis, roughSchedule);
    const ScoredPose scored{refined.pose, score_.of(refined.pose), refined.stopReason};
    ranked_.insert(std::upper_bound(ranked_.begin(), ranked_.end(), scored, isBetter), scored);
}

void AngioPose::tryStart()
{
    if (report("search", 0.0, roughSchedule.startScalePx) == Verdict::Continue) {
        rank(start_);
        report("search", 0.05, roughSchedule.endScalePx);
    }
}

std::vector<CentroidPose> AngioPose::search(const std::vector<AlignmentPoint>& points, const SearchPlan& plan)
{
    const CoarseSearch coarse(problem_.camera, *target_);
    const SearchReach reach{options_.searchRadiusMm, options_.searchTiltDeg, options_.searchRollDeg};
    const auto candidates = coarse.find(points, plan.start, reach, [&](double done) {
        return report("search", plan.progressFrom + done * (plan.progressTo - plan.progressFrom),
                      CoarseSearch::closenessPx);
    });
    std::vector<CentroidPose> poses;
    for (const CoarseCandidate& candidate : candidates) {
        poses.push_back(candidate.pose);
    }
    return poses;
}

std::vector<CentroidPose> AngioPose::searchHypotheses()
{
    return search(alignmentPoints(problem_.tree, strideFor(problem_.tree.size(), searchPoints)), {start_, 0.05, 0.2});
}

/// The same search from where the tree's middle meets the middle of the traced vessels (ALGORITHMS §5.4).
std::vector<CentroidPose> AngioPose::recentredHypotheses()
{
    Eigen::Vector2d middlePx = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& point : problem_.target.points) {
        middlePx += point / static_cast<double>(problem_.target.size());
    }
    CentroidPose recentred = start_;
    const double depthMm = std::max(minProjectableDepthMm, start_.centroidInCamera.z());
    const Eigen::Vector3d ray = rayThroughPixel(problem_.camera, middlePx);
    recentred.centroidInCamera = ray * (depthMm / ray.z());
    return search(alignmentPoints(problem_.tree, strideFor(problem_.tree.size(), searchPoints)), {recentred, 0.2, 0.3});
}

/// {p'} solved alone: chosen branches are searched for, nodes are refined from the best pose so far.
std::vector<CentroidPose> AngioPose::auxiliaryHypotheses()
{
    std::vector<CentroidPose> hypotheses;
    if (problem_.auxiliaryIsChosen && options_.search != 0.0) {
        std::vector<int> thinned;
        const std::size_t stride = strideFor(problem_.auxiliary.size(), searchPoints);
        for (std::size_t i = 0; i < problem_.auxiliary.size(); i += stride) {
            thinned.push_back(problem_.auxiliary[i]);
        }
        hypotheses = search(alignmentPoints(problem_.tree, thinned), {start_, 0.3, searchEnds});
        hypotheses.resize(std::min(hypotheses.size(), auxiliaryCandidates));
    }
    hypotheses.push_back(start_);
    if (!ranked_.empty()) {
        hypotheses.push_back(best().pose);
    }
    for (CentroidPose& hypothesis : hypotheses) {
        if (isStopped()) {
            break;
        }
        auxiliary_.resetVisibility();
        hypothesis = refine(auxiliary_, prior_, hypothesis, roughSchedule).pose;
        report("auxiliary", searchEnds, roughSchedule.endScalePx);
    }
    return hypotheses;
}

void AngioPose::refineRoughly(const std::vector<CentroidPose>& hypotheses)
{
    double done = 0.0;
    for (const CentroidPose& hypothesis : hypotheses) {
        if (isStopped()) {
            return;
        }
        rank(hypothesis);
        done += 1.0 / static_cast<double>(hypotheses.size());
        report("refine", searchEnds + done * (roughEnds - searchEnds), roughSchedule.endScalePx);
    }
}

ScoredPose AngioPose::refineFully(const CentroidPose& pose)
{
    rough_.resetVisibility();
    const RefinementResult middle = refine(rough_, prior_, pose, middleSchedule);
    if (const auto exact = refineWithExactPartners(problem_, middle.pose)) {
        return {*exact, score_.of(*exact), StopReason::Converged};
    }
    full_.resetVisibility();
    const double startScalePx = std::max(middle.scalePx, options_.finalScalePx);
    const RefinementSchedule schedule{startScalePx, options_.finalScalePx, 0.7, 2, 20, options_.maxIterations};
    const RefinementResult refined = refine(full_, prior_, middle.pose, schedule, [&](const RefinementStep& step) {
        return report("refine", roughEnds + step.progress * (1.0 - roughEnds), step.scalePx);
    });
    CentroidPose final = refined.pose;
    if (!isStopped()) {
        const auto exact = refineWithExactPartners(problem_, refined.pose);
        final = exact ? *exact : refineTolerantly(full_, prior_, refined.pose, refined.scalePx);
    }
    return {final, score_.of(final), refined.stopReason};
}

void AngioPose::refineFinalists()
{
    std::vector<ScoredPose> refined;
    for (const ScoredPose& candidate : ranked_) {
        const auto isSame = [&](const ScoredPose& other) {
            const Vector6d step = stepBetween(candidate.pose, other.pose);
            return step.head<3>().norm() < sameTurn && step.segment<2>(3).norm() < sameShiftMm;
        };
        if (isStopped() || refined.size() == finalists || candidate.score < worthRefining * best().score) {
            break;
        }
        if (std::none_of(refined.begin(), refined.end(), isSame)) {
            refined.push_back(refineFully(candidate.pose));
        }
    }
    if (!isStopped()) {
        std::stable_sort(refined.begin(), refined.end(), isBetter);
        ranked_ = std::move(refined);
        report("refine", 1.0, options_.finalScalePx);
    }
}

std::vector<Hypothesis> AngioPose::alternatives() const
{
    std::vector<Hypothesis> result;
    if (ranked_.size() < 2 || isStopped()) {
        return result;
    }
    const Matrix6d information =
        poseUncertainty(problem_, *target_, inPatient(best().pose), prior_).covariance.inverse();
    for (std::size_t k = 1; k < ranked_.size(); ++k) {
        const Vector6d step = stepBetween(best().pose, ranked_[k].pose);
        if (ranked_[k].score >= nearlyAsGood * best().score &&
            step.dot(information * step) > distinctSigmas * distinctSigmas) {
            result.push_back({inPatient(ranked_[k].pose), ranked_[k].score});
        }
    }
    return result;
}

}   // namespace

MethodSolution solveAngioPose(const RegistrationProblem& problem, const RegistrationOptions& options,
                              ProgressLog& progress)
{
    MethodSolution solution;
    Stopwatch stopwatch;
    AngioPose run(problem, options, progress);
    solution.time.targetMs = stopwatch.lapMs();

    run.tryStart();
    if (!run.isConclusive()) {
        if (options.search != 0.0 && !progress.isStopped()) {
            run.refineRoughly(run.searchHypotheses());
            if (run.isLost() && !progress.isStopped()) {
                run.refineRoughly(run.recentredHypotheses());
            }
        }
        if (!progress.isStopped()) {
            run.refineRoughly(run.auxiliaryHypotheses());
        }
    }
    solution.time.searchMs = stopwatch.lapMs();
    if (!progress.isStopped()) {
        run.refineFinalists();
    }
    solution.cameraFromPatient = run.hasPose() ? run.inPatient(run.best().pose) : problem.start;
    solution.stopReason = progress.isStopped() ? StopReason::StoppedByUser : run.best().stopReason;
    solution.iterations = progress.iterations();
    solution.alternatives = run.alternatives();
    solution.targetLines = run.target();
    solution.time.solveMs = stopwatch.lapMs();
    return solution;
}

}   // namespace core

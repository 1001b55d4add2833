#include "core/registration/methods/methods.h"

#include "core/geometry/angle_units.h"
#include "core/messages/messages.h"
#include "core/registration/alignment/alignment_points.h"
#include "core/registration/alignment/final_refinement.h"
#include "core/registration/alignment/pose_ranking.h"
#include "core/registration/alignment/pose_search.h"
#include "core/registration/judging/pose_uncertainty.h"
#include "core/registration/methods/auxiliary_fit.h"
#include "core/support/stopwatch.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr std::size_t finalistPoses = 3;
constexpr double worthRefining = 0.9;   // minimum score for fine refinement, as a fraction of the best coarse score
constexpr double nearlyAsGood = 0.95;   // minimum score of an alternative, as a fraction of the best (ALGORITHMS §6.10)
constexpr double distinctSigmas = 3.0;

// Progress at which each stage ends.
constexpr double searchEnds = 0.4;
constexpr double roughEnds = 0.8;

/// Caches the median distance to the target for progress reports until the pose changes.
class DistanceOfPose {
public:
    double of(const CentroidPose& pose, PoseRanking& ranking)
    {
        if (!pose_ || pose_->rotation != pose.rotation || pose_->centroidInCamera != pose.centroidInCamera) {
            pose_ = pose;
            distancePx_ = ranking.medianDistancePx(pose);
        }
        return distancePx_;
    }

private:
    std::optional<CentroidPose> pose_;
    double distancePx_ = 0.0;
};

/// One registration in progress: hypotheses → coarse refinement and ranking → finalists → best pose.
class AngioPose {
public:
    AngioPose(const RegistrationProblem& problem, const RegistrationOptions& options, ProgressLog& progress);

    void tryStart();
    void searchFurther();
    void refineFinalists();
    Messages fitAuxiliary();
    bool isMovedByAuxiliary() const { return isMovedByAuxiliary_; }

    RigidTransform pose() const { return rigidPose(bestPose()); }
    StopReason stopReason() const;
    std::vector<Hypothesis> alternatives() const;
    std::shared_ptr<const TargetLines> target() const { return target_; }
    std::optional<double> agreement() const;
    std::vector<std::uint8_t> opacifiedPoints() const;
    int opacifiedBifurcations() const { return refined_.empty() ? 0 : refined_.front().opacifiedBifurcations; }

private:
    using Search = std::vector<CentroidPose> (PoseSearch::*)(const CentroidPose&, const SearchObserver&) const;
    using AddFunction = void (PoseRanking::*)(const CentroidPose&);
    void refineRoughly(const std::vector<CentroidPose>& hypotheses, AddFunction file = &PoseRanking::add);
    void searchTerritories();
    ScoredPose refineFinely(const ScoredPose& candidate, FinalRefinement& ofWholeTree);
    void search(Search reach, const CentroidPose& start, double progress);
    std::vector<CentroidPose> auxiliaryHypotheses();
    const CentroidPose& bestPose() const;
    RigidTransform rigidPose(const CentroidPose& pose) const { return cameraFromPatient(pose, problem_.tree.centroid); }
    ObserverDecision report(std::string_view stage, double progress, double scalePx);

    const RegistrationProblem& problem_;
    const RegistrationOptions& options_;
    ProgressLog& progress_;
    std::shared_ptr<const TargetLines> target_;
    CentroidPose start_;
    InitialPosePrior prior_;
    PoseSearch search_;
    PoseRanking ranking_;
    DistanceOfPose reportedDistance_;
    std::vector<ScoredPose> refined_;   ///< refined finalists, best first; empty before that stage
    bool isMovedByAuxiliary_ =
        false;   ///< whether the auxiliary branches changed the pose from the fit of all branches
};

AngioPose::AngioPose(const RegistrationProblem& problem, const RegistrationOptions& options, ProgressLog& progress)
    : problem_(problem),
      options_(options),
      progress_(progress),
      target_(std::make_shared<const TargetLines>(problem.target, problem.camera)),
      start_(aboutCentroid(problem.start, problem.tree.centroid)),
      prior_(initialPosePrior(start_, options, problem.freedom)),
      search_(problem, *target_, options),
      ranking_(problem, *target_, prior_, TreeOpacification::Partial)
{
}

/// Reports the best pose so far.
ObserverDecision AngioPose::report(std::string_view stage, double progress, double scalePx)
{
    IterationReport report;
    report.stage = stage;
    report.progress = progress;
    report.scalePx = scalePx;
    report.medianDistancePx = reportedDistance_.of(bestPose(), ranking_);
    report.cameraFromPatient = rigidPose(bestPose());
    return progress_.report(report);
}

/// Refines the initial pose coarsely, which is often sufficient.
void AngioPose::tryStart()
{
    if (report("search", 0.0, PoseRanking::schedule.startScalePx) == ObserverDecision::Continue) {
        ranking_.add(start_);
        report("search", 0.05, PoseRanking::schedule.endScalePx);
    }
}

/// Searches increasingly large ranges until a pose explains the image.
void AngioPose::searchFurther()
{
    if (options_.angiopose.search && !ranking_.isConclusive()) {
        search(&PoseSearch::searchNearby, start_, 0.05);
    }
    if (options_.angiopose.search && !ranking_.isConclusive()) {
        searchTerritories();
    }
    if (options_.angiopose.search && !ranking_.isPlausible()) {
        search(&PoseSearch::searchWide, start_, 0.1);
    }
    if (options_.angiopose.search && ranking_.isMismatch()) {
        search(&PoseSearch::searchWide, search_.recenterPose(start_), 0.2);
    }
    for (const CentroidPose& middle : {start_, search_.recenterPose(start_)}) {
        if (options_.angiopose.search && ranking_.isMismatch()) {
            search(&PoseSearch::searchByJunctions, middle, 0.25);
        }
    }
    if (!progress_.isStopped() && !ranking_.isConclusive()) {
        refineRoughly(auxiliaryHypotheses());
    }
}

void AngioPose::search(Search reach, const CentroidPose& start, double progress)
{
    if (!progress_.isStopped()) {
        refineRoughly((search_.*reach)(start, [&](double done) {
            return report("search", progress + 0.1 * done, PoseRanking::schedule.startScalePx);
        }));
    }
}

/// Searches for poses of a partly opacified tree.
void AngioPose::searchTerritories()
{
    if (!progress_.isStopped()) {
        const auto found = search_.searchByTerritories(start_, [&](double done) {
            return report("search", 0.08 + 0.02 * done, PoseRanking::schedule.startScalePx);
        });
        refineRoughly(found, &PoseRanking::addPartlyOpacified);
    }
}

void AngioPose::refineRoughly(const std::vector<CentroidPose>& hypotheses, AddFunction file)
{
    for (const CentroidPose& hypothesis : hypotheses) {
        if (progress_.isStopped() || ranking_.isConclusive()) {
            return;
        }
        (ranking_.*file)(hypothesis);
        report("refine", searchEnds, PoseRanking::schedule.endScalePx);
    }
}

/// Returns poses refined with the auxiliary branches {p'} only, starting from the initial pose and the best pose so far
/// and, for branches selected by the user, also from a search.
std::vector<CentroidPose> AngioPose::auxiliaryHypotheses()
{
    std::vector<CentroidPose> hypotheses;
    if (problem_.hasUserAuxiliary && options_.angiopose.search) {
        hypotheses = search_.searchWithAuxiliary(start_, [&](double done) {
            return report("search", 0.3 + 0.1 * done, PoseRanking::schedule.startScalePx);
        });
    }
    hypotheses.push_back(start_);
    hypotheses.push_back(ranking_.best().pose);
    Alignment auxiliary(alignmentPoints(problem_.tree, problem_.auxiliary), problem_.camera, *target_);
    for (CentroidPose& hypothesis : hypotheses) {
        auxiliary.resetVisibility();
        hypothesis = refine(auxiliary, prior_, hypothesis, PoseRanking::schedule).pose;
        if (report("auxiliary", searchEnds, PoseRanking::schedule.endScalePx) == ObserverDecision::Stop) {
            break;
        }
    }
    return hypotheses;
}

/// Refines a candidate; excludes the parts of the tree that appear unopacified, as if the user had excluded them.
ScoredPose AngioPose::refineFinely(const ScoredPose& candidate, FinalRefinement& ofWholeTree)
{
    const auto observe = [&](const RefinementStep& step) {
        return report("refine", roughEnds + step.progress * (1.0 - roughEnds), step.scalePx);
    };
    RefinementResult result;
    if (candidate.isOpacified.empty()) {
        result = ofWholeTree.refine(candidate.pose, observe);
    } else {
        const RegistrationProblem filled = restrictProblem(problem_, candidate.isOpacified);
        result = FinalRefinement(filled, *target_, prior_, options_).refine(candidate.pose, observe);
    }
    return ranking_.scoredPose(result.pose, result.stopReason);
}

void AngioPose::refineFinalists()
{
    FinalRefinement refinement(problem_, *target_, prior_, options_);
    std::vector<ScoredPose> refined;
    for (const ScoredPose& candidate : ranking_.distinctPoses(worthRefining, finalistPoses)) {
        refined.push_back(refineFinely(candidate, refinement));
        if (progress_.isStopped()) {
            return;
        }
    }
    std::stable_sort(refined.begin(), refined.end(),
                     [](const ScoredPose& a, const ScoredPose& b) { return a.score > b.score; });
    refined_ = std::move(refined);
    report("refine", 1.0, options_.finalScalePx);
}

const CentroidPose& AngioPose::bestPose() const
{
    if (!refined_.empty()) {
        return refined_.front().pose;
    }
    return ranking_.isEmpty() ? start_ : ranking_.best().pose;
}

std::vector<std::uint8_t> AngioPose::opacifiedPoints() const
{
    return refined_.empty() ? std::vector<std::uint8_t>() : refined_.front().isOpacified;
}

/// Solves for the user's auxiliary branches, if any; the messages compare the result with the fit of all branches.
Messages AngioPose::fitAuxiliary()
{
    const double weight = options_.angiopose.auxiliaryWeight;
    if (!problem_.hasUserAuxiliary || weight == 1.0 || refined_.empty() || progress_.isStopped()) {
        return {};
    }
    ScoredPose& best = refined_.front();
    const std::optional<RegistrationProblem> filled =
        best.isOpacified.empty() ? std::nullopt : std::optional(restrictProblem(problem_, best.isOpacified));
    const RegistrationProblem& problem = filled ? *filled : problem_;
    if (!problem.hasUserAuxiliary) {   // the auxiliary branches appear unopacified
        return {};
    }
    const AuxiliaryFit fit = fitAuxiliaryBranches(problem, *target_, prior_, best.pose, weight);
    const Vector6d step = stepBetween(best.pose, fit.pose);
    isMovedByAuxiliary_ = step.norm() > 0.0;
    best = ranking_.scoredPose(fit.pose, best.stopReason);
    return {messages::auxiliaryBranchesFitted(Quantity{fit.medianPx, 2, "px"}, Quantity{fit.medianBeforePx, 2, "px"},
                                              Quantity{step.head<3>().norm() * degreesPerRadian, 2, "°"},
                                              inMm(step.tail<3>().norm(), 2))
                .as(Severity::Note)};
}

std::optional<double> AngioPose::agreement() const
{
    return refined_.empty() ? std::nullopt : std::optional(refined_.front().agreement);
}

StopReason AngioPose::stopReason() const
{
    return progress_.isStopped() ? StopReason::StoppedByUser : refined_.front().stopReason;
}

std::vector<Hypothesis> AngioPose::alternatives() const
{
    std::vector<Hypothesis> result;
    if (refined_.size() < 2) {
        return result;
    }
    const ScoredPose& best = refined_.front();
    const Matrix6d information = best.isOpacified.empty() ? poseInformation(problem_, *target_, best.pose, prior_)
                                                          : poseInformation(restrictProblem(problem_, best.isOpacified),
                                                                            *target_, best.pose, prior_);
    for (std::size_t k = 1; k < refined_.size(); ++k) {
        const Vector6d step = stepBetween(best.pose, refined_[k].pose);
        if (refined_[k].score >= nearlyAsGood * best.score &&
            step.dot(information * step) > distinctSigmas * distinctSigmas) {
            result.push_back({rigidPose(refined_[k].pose), refined_[k].score});
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
    solution.time.targetMs = stopwatch.takeLapMs();

    run.tryStart();
    if (!progress.isStopped()) {
        run.searchFurther();
    }
    solution.time.searchMs = stopwatch.takeLapMs();
    if (!progress.isStopped()) {
        run.refineFinalists();
    }
    solution.warnings = run.fitAuxiliary();
    solution.cameraFromPatient = run.pose();
    solution.stopReason = run.stopReason();
    solution.iterations = progress.iterations();
    solution.alternatives = run.alternatives();
    solution.targetLines = run.target();
    solution.agreement = run.agreement();
    solution.isOpacified = run.opacifiedPoints();
    solution.opacifiedBifurcations = run.opacifiedBifurcations();
    solution.isFullyRefined = !progress.isStopped() && !run.isMovedByAuxiliary();
    solution.needsChecks = !progress.isStopped();
    solution.time.solveMs = stopwatch.takeLapMs();
    return solution;
}

}   // namespace angiopose::core

#include "core/registration/track_frames.h"

#include "core/registration/alignment/alignment_points.h"
#include "core/registration/alignment/pose_ranking.h"
#include "core/support/quantile.h"
#include "core/support/stopwatch.h"

#include <utility>

namespace angiopose::core {
namespace {

constexpr std::size_t usedTrackingPoints = 250;
constexpr std::size_t rememberedScores = 15;
constexpr double minRelativeScore =
    0.8;   // minimum score of a fit, as a fraction of the median score of the last frames
constexpr double minScore = 0.25;   // minimum score of any fit; lower scores are meaningless (see PoseRanking)
constexpr RefinementSchedule fromPrediction{6.0, 1.0, 0.55, 2, 4, 16};

}   // namespace

FrameTracker::FrameTracker(RegistrationProblem first, const RegistrationOptions& options,
                           const MotionModel::Noise& noise)
    : problem_(std::move(first)),
      options_(options),
      motion_(aboutCentroid(problem_.start, problem_.tree.centroid), problem_.tree.spreadMm, noise),
      points_(alignmentPoints(problem_.tree, strideFor(problem_.tree.size(), usedTrackingPoints)))
{
}

/// Replaces the tree but keeps its centroid, to which the poses refer.
void FrameTracker::updateTree(RegistrationProblem deformed)
{
    deformed.tree.centroid = problem_.tree.centroid;
    problem_ = std::move(deformed);
    points_ = alignmentPoints(problem_.tree, strideFor(problem_.tree.size(), usedTrackingPoints));
}

double FrameTracker::medianScore() const
{
    return scores_.empty() ? 0.0 : quantile({scores_.begin(), scores_.end()}, 0.5);
}

bool FrameTracker::isGoodFit(double score) const
{
    return score >= std::max(minScore, minRelativeScore * medianScore());
}

Result<TrackedFrame> FrameTracker::next(const Centerline2d& target, const SearchObserver& observe)
{
    if (const auto problem = findProblem(target)) {
        return Error(*problem);
    }
    Stopwatch stopwatch;
    problem_.target = sampleTarget(target, options_);
    const TargetLines lines(problem_.target, problem_.camera);
    TrackedFrame frame;
    frame.time.targetMs = stopwatch.takeLapMs();

    InitialPosePrior prediction = motion_.predict();
    prediction.freedom = problem_.freedom;
    prediction.start = problem_.freedom.restoreLockedAxes(prediction.start);
    AgreementScore agreement(problem_, lines);
    Alignment alignment(points_, problem_.camera, lines);
    CentroidPose pose = refine(alignment, prediction, prediction.start, fromPrediction).pose;
    frame.score = agreement.scoreAt(pose);
    frame.time.solveMs = stopwatch.takeLapMs();

    if (!isGoodFit(frame.score)) {
        frame.isFromSearch = true;
        pose = searchAround(lines, prediction.start, pose, observe);
        frame.score = agreement.scoreAt(pose);
        frame.time.searchMs = stopwatch.takeLapMs();
    }
    frame.isTrustworthy = isGoodFit(frame.score);
    updateMotion(frame, pose);
    frame.cameraFromPatient = cameraFromPatient(frame.isTrustworthy ? pose : prediction.start, problem_.tree.centroid);
    frame.time.totalMs = frame.time.targetMs + frame.time.solveMs + frame.time.searchMs;
    return frame;
}

CentroidPose FrameTracker::searchAround(const TargetLines& lines, const CentroidPose& prediction,
                                        const CentroidPose& refined, const SearchObserver& observe) const
{
    const InitialPosePrior anywhereNear = initialPosePrior(prediction, options_, problem_.freedom);
    PoseRanking ranking(problem_, lines, anywhereNear);
    ranking.add(refined);
    const PoseSearch search(problem_, lines, options_);
    const SearchObserver report = [&observe](double done) {
        return observe ? observe(done) : ObserverDecision::Continue;
    };
    for (const CentroidPose& found : search.searchNearby(prediction, report)) {
        if (report(1.0) == ObserverDecision::Stop) {
            break;
        }
        ranking.add(found);
    }
    Alignment alignment(points_, problem_.camera, lines);
    return refine(alignment, anywhereNear, ranking.best().pose, fromPrediction).pose;
}

void FrameTracker::updateMotion(const TrackedFrame& frame, const CentroidPose& pose)
{
    if (!frame.isTrustworthy) {
        motion_.advance({});
        return;
    }
    if (frame.isFromSearch) {
        motion_.resetTo(pose);
    } else {
        motion_.advance(pose);
    }
    scores_.push_back(frame.score);
    if (scores_.size() > rememberedScores) {
        scores_.pop_front();
    }
}

}   // namespace angiopose::core

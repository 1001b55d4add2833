#include "core/registration/alignment/pose_ranking.h"
#include "core/registration/alignment/alignment_points.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr std::size_t usedRankingPoints = 200;
constexpr std::size_t maxHypotheses = 64;   // upper bound; no search returns this many
constexpr double perUnitOfPrior = 0.01;   // an initial pose off by 2σ in all six parameters costs a fifth of the score
constexpr double wholeTreeEnough = 0.65;   // agreement above which no part of the tree is considered unopacified
constexpr double clearlyBetter = 0.1;
constexpr double sameTurn = 0.02;
constexpr double sameShiftMm = 3.0;

bool isSame(const CentroidPose& a, const CentroidPose& b)
{
    const Vector6d step = stepBetween(a, b);
    return step.head<3>().norm() < sameTurn && step.segment<2>(3).norm() < sameShiftMm;
}

}   // namespace

PoseRanking::PoseRanking(const RegistrationProblem& problem, const TargetLines& target, const StartPrior& prior,
                         TreeFilling filling)
    : prior_(prior),
      filling_(filling),
      points_(alignmentPoints(problem.tree, strideFor(problem.tree.size(), usedRankingPoints)), problem.camera, target),
      agreement_(problem, target)
{
    ranked_.reserve(maxHypotheses);
    distances_.reserve(points_.size());
}

void PoseRanking::add(const CentroidPose& hypothesis)
{
    points_.resetVisibility();
    file(hypothesis);
}

void PoseRanking::addFilled(const CentroidPose& hypothesis)
{
    points_.setVisibility(points_.evaluate(hypothesis, schedule.startScalePx));
    file(hypothesis);
}

void PoseRanking::file(const CentroidPose& hypothesis)
{
    const RefinementResult refined = refine(points_, prior_, hypothesis, schedule);
    const ScoredPose candidate = scored(refined.pose, refined.stopReason);
    const auto isBetter = [](const ScoredPose& a, const ScoredPose& b) { return a.score > b.score; };
    ranked_.insert(std::upper_bound(ranked_.begin(), ranked_.end(), candidate, isBetter), candidate);
}

ScoredPose PoseRanking::scored(const CentroidPose& pose, StopReason stopReason)
{
    ScoredPose scored{pose, 0.0, agreement_.of(pose), stopReason};
    if (filling_ == TreeFilling::InParts && scored.agreement < wholeTreeEnough) {
        const FilledAgreement filled = agreement_.ofFilled(pose);
        if (filled.agreement > scored.agreement + clearlyBetter) {
            scored.agreement = filled.agreement;
            scored.filledForks = agreement_.filling().forks(filled.isOpacified);
            for (const int piece : agreement_.filling().pieceOfPoint()) {
                scored.isOpacified.push_back(filled.isOpacified[static_cast<std::size_t>(piece)]);
            }
        }
    }
    scored.score = scored.agreement / (1.0 + perUnitOfPrior * prior_.cost(pose));
    return scored;
}

std::vector<ScoredPose> PoseRanking::distinct(double share, std::size_t count) const
{
    std::vector<ScoredPose> chosen;
    for (const ScoredPose& candidate : ranked_) {
        if (chosen.size() == count || candidate.score < share * best().score) {
            break;
        }
        if (std::none_of(chosen.begin(), chosen.end(),
                         [&](const ScoredPose& other) { return isSame(candidate.pose, other.pose); })) {
            chosen.push_back(candidate);
        }
    }
    return chosen;
}

}   // namespace angiopose::core

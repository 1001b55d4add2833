#include "core/registration/alignment/pose_ranking.h"
#include "core/registration/alignment/alignment_points.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr std::size_t usedRankingPoints = 200;
constexpr std::size_t maxHypotheses = 64;   // upper bound; no search returns this many
constexpr double priorPenalty = 0.01;   // an initial pose off by 2σ in all six parameters costs a fifth of the score
constexpr double minWholeTreeAgreement = 0.65;   // agreement above which no part of the tree is considered unopacified
constexpr double clearlyBetter = 0.1;
constexpr double sameTurn = 0.02;
constexpr double sameShiftMm = 3.0;

bool isSame(const CentroidPose& a, const CentroidPose& b)
{
    const Vector6d step = stepBetween(a, b);
    return step.head<3>().norm() < sameTurn && step.segment<2>(3).norm() < sameShiftMm;
}

}   // namespace

PoseRanking::PoseRanking(const RegistrationProblem& problem, const TargetLines& target, const InitialPosePrior& prior,
                         TreeOpacification opacification)
    : prior_(prior),
      opacification_(opacification),
      alignment_(alignmentPoints(problem.tree, strideFor(problem.tree.size(), usedRankingPoints)), problem.camera,
                 target),
      agreementScore_(problem, target)
{
    rankedPoses_.reserve(maxHypotheses);
    distances_.reserve(alignment_.size());
}

void PoseRanking::add(const CentroidPose& hypothesis)
{
    alignment_.resetVisibility();
    refineAndInsert(hypothesis);
}

void PoseRanking::addPartlyOpacified(const CentroidPose& hypothesis)
{
    alignment_.setVisibility(alignment_.evaluate(hypothesis, schedule.startScalePx));
    refineAndInsert(hypothesis);
}

void PoseRanking::refineAndInsert(const CentroidPose& hypothesis)
{
    const RefinementResult refined = refine(alignment_, prior_, hypothesis, schedule);
    const ScoredPose candidate = scoredPose(refined.pose, refined.stopReason);
    const auto isBetter = [](const ScoredPose& a, const ScoredPose& b) { return a.score > b.score; };
    rankedPoses_.insert(std::upper_bound(rankedPoses_.begin(), rankedPoses_.end(), candidate, isBetter), candidate);
}

ScoredPose PoseRanking::scoredPose(const CentroidPose& pose, StopReason stopReason)
{
    ScoredPose scoredPose{pose, 0.0, agreementScore_.scoreAt(pose), stopReason};
    if (opacification_ == TreeOpacification::Partial && scoredPose.agreement < minWholeTreeAgreement) {
        const OpacifiedAgreement filled = agreementScore_.scoreOpacified(pose);
        if (filled.agreement > scoredPose.agreement + clearlyBetter) {
            scoredPose.agreement = filled.agreement;
            scoredPose.opacifiedBifurcations =
                agreementScore_.opacification().countOpacifiedBifurcations(filled.isOpacified);
            for (const int piece : agreementScore_.opacification().segmentOfPoint()) {
                scoredPose.isOpacified.push_back(filled.isOpacified[static_cast<std::size_t>(piece)]);
            }
        }
    }
    scoredPose.score = scoredPose.agreement / (1.0 + priorPenalty * prior_.cost(pose));
    return scoredPose;
}

std::vector<ScoredPose> PoseRanking::distinctPoses(double fraction, std::size_t count) const
{
    std::vector<ScoredPose> chosen;
    for (const ScoredPose& candidate : rankedPoses_) {
        if (chosen.size() == count || candidate.score < fraction * best().score) {
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

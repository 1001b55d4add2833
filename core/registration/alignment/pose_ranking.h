#pragma once

#include "core/registration/alignment/agreement_score.h"
#include "core/registration/alignment/graduated_refinement.h"

namespace angiopose::core {

struct ScoredPose {
    CentroidPose pose;
    double score = 0.0;   ///< agreement in both directions, reduced by the distance from the initial pose; 0…1
    double agreement =
        0.0;   ///< score without that reduction; of the opacified parts where these explain the image clearly better
    StopReason stopReason = StopReason::Converged;
    std::vector<std::uint8_t> isOpacified{};   ///< one per tree point; empty if the whole tree is expected in the image
    int opacifiedBifurcations = 0;   ///< number of bifurcations where three or more opacified segments meet
};

/// Extent to which the tree is assumed to be opacified (ALGORITHMS §6.17).
enum class TreeOpacification { Whole, Partial };

/// Ranks hypotheses by how well they explain the image after a coarse refinement with few points, down to a scale of a
/// few pixels. The thresholds were determined on 60 wrong optima for each of 60 simulated trees: none of these had a
/// score above 0.56, while true poses score 0.96 on clean targets, 0.6 to 0.87 with missing vessels and clutter, and
/// 0.3 to 0.65 on traced angiograms, where most thin vessels are not traced.
class PoseRanking {
public:
    static constexpr RefinementSchedule schedule{14.0, 2.5, 0.6, 2, 0, 40};

    PoseRanking(const RegistrationProblem& problem, const TargetLines& target, const InitialPosePrior& prior,
                TreeOpacification opacification = TreeOpacification::Whole);

    /// Refines the hypothesis and adds it to the ranking.
    void add(const CentroidPose& hypothesis);

    /// Like add, for a hypothesis in which only parts of the tree lie on vessels; branches without a matching vessel do
    /// not contribute.
    void addPartlyOpacified(const CentroidPose& hypothesis);

    ScoredPose scoredPose(const CentroidPose& pose, StopReason stopReason);

    bool isEmpty() const { return rankedPoses_.empty(); }
    const ScoredPose& best() const { return rankedPoses_.front(); }

    /// Whether tree and traced vessels explain each other well enough to skip further searches.
    bool isConclusive() const { return hasScore(0.65); }
    /// Whether the fit is uncertain but unlikely to be a coincidence.
    bool isPlausible() const { return hasScore(0.55); }
    /// Whether the tree matches hardly any vessel.
    bool isMismatch() const { return !hasScore(0.4); }

    /// Returns the best pose of every optimum, best first, limited to those that score at least `share` of the best.
    std::vector<ScoredPose> distinctPoses(double fraction, std::size_t count) const;

    /// Returns the median distance to the target, px, for the progress display.
    double medianDistancePx(const CentroidPose& pose) { return alignment_.medianDistancePx(pose, distances_); }

private:
    void refineAndInsert(const CentroidPose& hypothesis);
    bool hasScore(double score) const { return !rankedPoses_.empty() && best().score >= score; }

    InitialPosePrior prior_;
    TreeOpacification opacification_;
    Alignment alignment_;
    AgreementScore agreementScore_;
    std::vector<ScoredPose> rankedPoses_;   ///< best first
    std::vector<double> distances_;
};

}   // namespace angiopose::core

#pragma once

#include "core/registration/alignment/agreement_score.h"
#include "core/registration/alignment/graduated_refinement.h"

namespace angiopose::core {

struct ScoredPose {
    CentroidPose pose;
    double score = 0.0;   ///< agreement both ways, lowered by distance from the start pose; 0…1
    double agreement = 0.0;   ///< not lowered; of the filled parts where these explain the image clearly better
    StopReason stopReason = StopReason::Converged;
    std::vector<std::uint8_t> isOpacified{};   ///< per tree point; empty: all of the tree is looked for
    int filledForks = 0;   ///< places where three filled pieces or more meet
};

/// Whether parts of the tree may be empty (ALGORITHMS §6.17).
enum class TreeFilling { Whole, InParts };

/// Hypotheses refined roughly, on few points and down to a few pixels, in the order of how well they explain the image.
/// What the scores mean was measured on 60 wrong optima for each of 60 simulated trees: none of them scored above 0.56,
/// while true poses score 0.96 on clean targets, 0.6 to 0.87 with missing vessels and clutter, 0.3 to 0.65 on traced
/// angiograms, where most thin vessels are not traced.
class PoseRanking {
public:
    static constexpr RefinementSchedule schedule{14.0, 2.5, 0.6, 2, 0, 40};

    PoseRanking(const RegistrationProblem& problem, const TargetLines& target, const StartPrior& prior,
                TreeFilling filling = TreeFilling::Whole);

    /// Refines the hypothesis and files it.
    void add(const CentroidPose& hypothesis);

    /// The same for a pose that lays parts of the tree on the vessels: branches that lie on nothing do not pull.
    void addFilled(const CentroidPose& hypothesis);

    ScoredPose scored(const CentroidPose& pose, StopReason stopReason);

    bool isEmpty() const { return ranked_.empty(); }
    const ScoredPose& best() const { return ranked_.front(); }

    /// Tree and traced vessels explain each other: no search can do better.
    bool isConclusive() const { return reaches(0.65); }
    /// Not sure, but unlikely to be a mere coincidence.
    bool isPlausible() const { return reaches(0.55); }
    /// The tree lies on next to nothing.
    bool isLost() const { return !reaches(0.4); }

    /// The best pose of every optimum, best first, as far as they score at least `share` of the best.
    std::vector<ScoredPose> distinct(double share, std::size_t count) const;

    /// Median distance to the target, px; for progress.
    double medianDistancePx(const CentroidPose& pose) { return points_.medianDistancePx(pose, distances_); }

private:
    void file(const CentroidPose& hypothesis);
    bool reaches(double score) const { return !ranked_.empty() && best().score >= score; }

    StartPrior prior_;
    TreeFilling filling_;
    Alignment points_;
    AgreementScore agreement_;
    std::vector<ScoredPose> ranked_;   ///< best first
    std::vector<double> distances_;
};

}   // namespace angiopose::core
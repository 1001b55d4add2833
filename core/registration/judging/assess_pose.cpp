#include "core/registration/judging/assess_pose.h"

#include "core/registration/alignment/agreement_score.h"
#include "core/registration/alignment/branch_segments.h"
#include "core/registration/alignment/camera_influence.h"
#include "core/registration/judging/confidence.h"
#include "core/registration/judging/distance_metrics.h"
#include "core/registration/judging/followed_vessels.h"
#include "core/registration/judging/observed_diameter.h"
#include "core/registration/judging/pose_shift.h"
#include "core/registration/judging/pose_uncertainty.h"
#include "core/registration/judging/unopacified_branches.h"
#include "core/registration/matching/target_lines.h"
#include "core/registration/problem/method_solution.h"

#include <algorithm>

namespace angiopose::core {

namespace {

/// A pose with the tree projected at it, and the uncertainty of the pose.
struct PoseInImage {
    const RegistrationProblem& problem;
    const TargetLines& target;
    const ProjectedTree& projected;
    const PoseUncertainty& uncertainty;
};

template <class Value, class Predicate>
double shareOf(const std::vector<Value>& values, const Predicate& holds)
{
    return static_cast<double>(std::ranges::count_if(values, holds)) / static_cast<double>(values.size());
}

double agreementOf(const PoseInImage& seen, const RigidTransform& pose)
{
    return AgreementScore(seen.problem, seen.target).scoreAt(aboutCentroid(pose, seen.problem.tree.centroid));
}

constexpr int maxOfPath = 4;   // maximum number of matched branches of a single path

/// Whether the matched part of a connected tree has no bifurcation, as for a guidewire, a catheter or a single vessel.
bool isSinglePath(const PoseInImage& seen)
{
    const BranchSegments parts = splitAtBifurcations(seen.problem.tree);
    const auto isSeen = [&seen](const BranchSegment& piece) {
        const double* from = seen.projected.distancePx.data() + piece.from;
        const auto count = static_cast<std::ptrdiff_t>(piece.to - piece.from);
        return 2 * std::count_if(from, from + count, [](double px) { return px <= matchTolerancePx; }) >= count;
    };
    std::vector<int> meeting(static_cast<std::size_t>(parts.junctionCount), 0), seenThere(meeting);
    for (const SegmentIncidence& joint : parts.incidences) {
        const auto junction = static_cast<std::size_t>(joint.junction);
        ++meeting[junction];
        seenThere[junction] += isSeen(parts.pieces[static_cast<std::size_t>(joint.piece)]) ? 1 : 0;
    }
    auto components = static_cast<int>(parts.pieces.size());
    for (const int pieces : meeting) {
        components -= std::max(0, pieces - 1);
    }
    return components <= 1 && std::ranges::all_of(seenThere, [](int pieces) { return pieces < 3; });
}

/// Computes the indicators from which the pose error of a solution is estimated.
FitIndicators computeIndicators(const PoseInImage& seen, const RegistrationOptions& options,
                                const MethodSolution& solution)
{
    const RigidTransform& pose = solution.cameraFromPatient;
    const FollowedVessels followed = followedVessels(seen.problem, seen.target, pose, seen.projected);
    FitIndicators indicators;
    indicators.agreement = solution.agreement ? *solution.agreement : agreementOf(seen, pose);
    indicators.treeFraction =
        shareOf(seen.projected.distancePx, [](double distance) { return distance <= matchTolerancePx; });
    indicators.inViewFraction = shareOf(seen.projected.isInView, [](std::uint8_t isInView) { return isInView != 0; });
    indicators.followedShare = followed.share();
    indicators.followedMm = followed.followedMm;
    indicators.followedBranches = followed.branchesFollowed;
    indicators.refinementMm =
        solution.isFullyRefined ? 0.0 : refinementShiftMm(seen.problem, seen.target, pose, options);
    indicators.expectedErrorMm = expectedShiftMm(seen.problem, pose, seen.uncertainty);
    for (const Hypothesis& other : solution.alternatives) {
        indicators.alternativeMm =
            std::max(indicators.alternativeMm, meanShiftMm(seen.problem.tree, pose, other.cameraFromPatient));
    }
    indicators.isPartlyOpacified = std::ranges::count(solution.isOpacified, std::uint8_t{1}) > 0;
    indicators.opacifiedBifurcations = solution.opacifiedBifurcations;
    indicators.isLumen = isLumen(observedDiameter(seen.problem, seen.target, pose, seen.projected));
    indicators.isSinglePath = followed.branchesFollowed <= maxOfPath && isSinglePath(seen);
    return indicators;
}

constexpr double settledMm = 0.3;   // maximum shift by refinement up to which the camera is assessed

bool anyIsOpacified(const MethodSolution& solution)
{
    return std::ranges::count(solution.isOpacified, std::uint8_t{1}) > 0;
}

}   // namespace

RegistrationResult assessPose(const RegistrationProblem& whole, const RegistrationOptions& options,
                              const MethodSolution& solution)
{
    const std::optional<RegistrationProblem> filled =
        anyIsOpacified(solution) ? std::optional(restrictProblem(whole, solution.isOpacified)) : std::nullopt;
    const RegistrationProblem& problem = filled ? *filled : whole;
    const RigidTransform& pose = solution.cameraFromPatient;
    const auto lines = solution.targetLines ? solution.targetLines
                                            : std::make_shared<const TargetLines>(problem.target, problem.camera);
    const GridIndex target(problem.target.points);
    const ProjectedTree projected = projectTree(problem, pose, target);
    const InitialPosePrior prior =
        initialPosePrior(aboutCentroid(problem.start, problem.tree.centroid), options, problem.freedom);

    RegistrationResult result;
    result.cameraFromPatient = pose;
    result.stopReason = solution.stopReason;
    result.iterations = solution.iterations;
    result.metrics = distanceMetrics(problem, pose, projected);
    const ProjectedTree projectedWhole = filled ? projectTree(whole, pose, target) : projected;
    result.branches = branchResiduals(whole.tree, projectedWhole);
    const UncertaintyEstimate estimate = estimateUncertainty(problem, *lines, pose, prior);
    result.uncertainty = estimate.uncertainty;
    result.camera = estimate.camera;
    result.alternatives = solution.alternatives;
    result.time = solution.time;

    result.indicators = computeIndicators({problem, *lines, projected, result.uncertainty}, options, solution);
    ConfidenceAssessment confidence = assessConfidence(problem, result);
    result.trustworthy = confidence.isTrustworthy;
    if (filled) {
        result.unopacified = unopacifiedBranches(whole.tree, solution.isOpacified, projectedWhole.isInView);
        const Messages reported = unopacifiedMessages(result.unopacified, opacifiedLengthFraction(solution.isOpacified),
                                                      whole.tree.branchIds.size());
        confidence.warnings.insert(confidence.warnings.end(), reported.begin(), reported.end());
    }
    result.warnings = whole.notes;
    result.warnings.insert(result.warnings.end(), solution.warnings.begin(), solution.warnings.end());
    result.warnings.insert(result.warnings.end(), confidence.warnings.begin(), confidence.warnings.end());
    if (result.camera && result.indicators.refinementMm < settledMm) {
        const Messages contradictions = contradictionsOf(*result.camera, problem.camera);
        result.warnings.insert(result.warnings.end(), contradictions.begin(), contradictions.end());
    }
    return result;
}

}   // namespace angiopose::core

#include "core/registration/judging/judge_pose.h"

#include "core/registration/alignment/camera_influence.h"
#include "core/registration/judging/fit_signs.h"
#include "core/registration/judging/pose_uncertainty.h"
#include "core/registration/judging/trust.h"
#include "core/registration/judging/unfilled_branches.h"
#include "core/registration/matching/target_lines.h"

#include <algorithm>

namespace angiopose::core {

namespace {

constexpr double settledMm = 0.3;   // a pose that slides farther carries no information about its camera

bool anyIsOpacified(const MethodSolution& solution)
{
    return std::ranges::count(solution.isOpacified, std::uint8_t{1}) > 0;
}

}   // namespace

RegistrationResult judgePose(const RegistrationProblem& whole, const RegistrationOptions& options,
                             const MethodSolution& solution)
{
    const std::optional<RegistrationProblem> filled =
        anyIsOpacified(solution) ? std::optional(partOf(whole, solution.isOpacified)) : std::nullopt;
    const RegistrationProblem& problem = filled ? *filled : whole;
    const RigidTransform& pose = solution.cameraFromPatient;
    const auto lines = solution.targetLines ? solution.targetLines
                                            : std::make_shared<const TargetLines>(problem.target, problem.camera);
    const GridIndex target(problem.target.points);
    const ProjectedTree projected = projectTree(problem, pose, target);
    const StartPrior prior = startPrior(aboutCentroid(problem.start, problem.tree.centroid), options, problem.freedom);

    RegistrationResult result;
    result.cameraFromPatient = pose;
    result.stopReason = solution.stopReason;
    result.iterations = solution.iterations;
    result.metrics = distanceMetrics(problem, pose, projected);
    const ProjectedTree projectedWhole = filled ? projectTree(whole, pose, target) : projected;
    result.branches = branchResiduals(whole.tree, projectedWhole);
    const PoseKnowledge knowledge = poseKnowledge(problem, *lines, pose, prior);
    result.uncertainty = knowledge.uncertainty;
    result.camera = knowledge.camera;
    result.alternatives = solution.alternatives;
    result.time = solution.time;

    result.signs = fitSigns({problem, *lines, projected, result.uncertainty}, options, solution);
    Trust trust = judgeTrust(problem, result);
    result.trustworthy = trust.isTrustworthy;
    if (filled) {
        result.unopacified = unopacifiedBranches(whole.tree, solution.isOpacified, projectedWhole.isInView);
        const Messages reported =
            wordsOf(result.unopacified, shareFilled(solution.isOpacified), whole.tree.branchIds.size());
        trust.warnings.insert(trust.warnings.end(), reported.begin(), reported.end());
    }
    result.warnings = whole.notes;
    result.warnings.insert(result.warnings.end(), solution.warnings.begin(), solution.warnings.end());
    result.warnings.insert(result.warnings.end(), trust.warnings.begin(), trust.warnings.end());
    if (result.camera && result.signs.settlingMm < settledMm) {
        const Messages said = contradictionsOf(*result.camera, problem.camera);
        result.warnings.insert(result.warnings.end(), said.begin(), said.end());
    }
    return result;
}

}   // namespace angiopose::core
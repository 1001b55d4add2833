#include "core/registration/judging/judge_pose.h"

#include "core/registration/alignment/agreement_score.h"
#include "core/registration/judging/distance_metrics.h"
#include "core/registration/judging/pose_shift.h"
#include "core/registration/judging/pose_uncertainty.h"
#include "core/registration/judging/trust.h"
#include "core/registration/matching/target_lines.h"

#include <algorithm>

namespace angiopose::core {

RegistrationResult judgePose(const RegistrationProblem& problem, const RegistrationOptions& options,
                             const MethodSolution& solution)
{
    const RigidTransform& pose = solution.cameraFromPatient;
    const auto lines = solution.targetLines ? solution.targetLines
                                            : std::make_shared<const TargetLines>(problem.target, problem.camera);
    const ProjectedTree projected = projectTree(problem, pose, GridIndex(problem.target.points));
    const StartPrior prior = startPrior(aboutCentroid(problem.start, problem.tree.centroid), options, problem.freedom);

    RegistrationResult result;
    result.cameraFromPatient = pose;
    result.stopReason = solution.stopReason;
    result.iterations = solution.iterations;
    result.metrics = distanceMetrics(problem, pose, projected);
    result.branches = branchResiduals(problem.tree, projected);
    result.uncertainty = poseUncertainty(problem, *lines, pose, prior);
    result.alternatives = solution.alternatives;
    result.time = solution.time;

    Evidence evidence{problem, projected, result, *lines};
    evidence.agreement = solution.agreement
                             ? *solution.agreement
                             : AgreementScore(problem, *lines).of(aboutCentroid(pose, problem.tree.centroid));
    evidence.settlingMm = solution.isSettled ? 0.0 : settlingShiftMm(problem, *lines, pose, options);
    evidence.expectedErrorMm = expectedShiftMm(problem, pose, result.uncertainty);
    for (const Hypothesis& other : solution.alternatives) {
        evidence.rivalMm = std::max(evidence.rivalMm, meanShiftMm(problem.tree, pose, other.cameraFromPatient));
    }
    Trust trust = judgeTrust(evidence);
    result.trustworthy = trust.isTrustworthy;
    result.warnings = solution.warnings;
    result.warnings.insert(result.warnings.end(), trust.warnings.begin(), trust.warnings.end());
    return result;
}

}   // namespace angiopose::core
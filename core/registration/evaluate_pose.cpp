#include "core/registration/registration.h"

#include "core/messages/says.h"
#include "core/registration/judging/judge_pose.h"

namespace angiopose::core {

Result<RegistrationResult> evaluatePose(const RegistrationInput& input, const RigidTransform& cameraFromPatient)
{
    if (!isRigid(cameraFromPatient)) {
        return Error(says::judgedPoseNotRigid());
    }
    const RegistrationOptions options;
    const Result<RegistrationProblem> problem = makeProblem(input, options);
    if (!problem) {
        return problem.error();
    }
    MethodSolution solution;
    solution.cameraFromPatient = cameraFromPatient;
    solution.stopReason = StopReason::Converged;
    return judgePose(problem.value(), options, solution);
}

}   // namespace angiopose::core
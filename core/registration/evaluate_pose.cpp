#include "core/registration/judging/judge_pose.h"

namespace angiopose::core {

Result<RegistrationResult> evaluatePose(const RegistrationInput& input, const RigidTransform& cameraFromPatient)
{
    if (!isRigid(cameraFromPatient)) {
        return Error{
            "The pose to judge is not a rigid motion: its rotation must be orthonormal with determinant +1 and "
            "all numbers finite."};
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
#include "core/workflow/pose_judgement.h"

#include "core/evaluation/trial/branch_distances.h"

namespace angiopose::core {

Result<PoseJudgement> judgementOf(const RegistrationInput& input, const RigidTransform& cameraFromPatient)
{
    auto result = evaluatePose(input, cameraFromPatient);
    if (!result) {
        return result.error();
    }
    return PoseJudgement{std::move(result).value(),
                         branchDistances(input.tree, input.target, input.camera, cameraFromPatient)};
}

}   // namespace angiopose::core

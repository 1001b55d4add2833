#include "core/registration/registration.h"

#include "core/messages/messages.h"
#include "core/registration/deformation_check.h"
#include "core/registration/judging/judge_pose.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double settledMm = 1.3;   // beyond this the pose does not match the image (see judgeTrust)
constexpr double mostlyExplained = 0.5;

/// Withdraws the single-path warning unless the pose explains the image: at a wrong pose, even a fully opacified tree
/// seems to match only a few vessels.
void withdrawSinglePath(RegistrationResult& judged)
{
    const FitSigns& signs = judged.signs;
    const bool explains = signs.settlingMm <= settledMm && judged.metrics.coverage >= mostlyExplained;
    const auto withdrawn = explains ? 0 : std::erase_if(judged.warnings, [](const Message& said) {
        return said.is(messages::trustSinglePath);
    });
    if (withdrawn > 0 && std::ranges::none_of(judged.warnings, speaksAgainstTrust)) {
        judged.warnings.insert(judged.warnings.begin(),
                               messages::trustLittleAgreement(Quantity{100.0 * signs.treeShare, 0, "%"},
                                                              Quantity{100.0 * judged.metrics.coverage, 0, "%"}));
    }
}

}   // namespace

Result<RegistrationResult> evaluatePose(const RegistrationInput& input, const RigidTransform& cameraFromPatient)
{
    if (!isRigid(cameraFromPatient)) {
        return Error(messages::judgedPoseNotRigid());
    }
    const RegistrationOptions options;
    const Result<RegistrationProblem> problem = makeProblem(input, options);
    if (!problem) {
        return problem.error();
    }
    MethodSolution solution;
    solution.cameraFromPatient = cameraFromPatient;
    solution.stopReason = StopReason::Converged;
    RegistrationResult judged = judgePose(problem.value(), options, solution);
    withdrawSinglePath(judged);
    return judged;
}

}   // namespace angiopose::core

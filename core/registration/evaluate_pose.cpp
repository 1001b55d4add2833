#include "core/registration/registration.h"

#include "core/messages/messages.h"
#include "core/registration/deformation_check.h"
#include "core/registration/judging/assess_pose.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double maxRefinementMm = 1.3;   // beyond this the pose does not match the image (see assessConfidence)
constexpr double mostlyExplained = 0.5;

/// Withdraws the single-path warning unless the pose explains the image: at a wrong pose, even a fully opacified tree
/// seems to match only a few vessels.
void withdrawSinglePath(RegistrationResult& assessed)
{
    const FitIndicators& indicators = assessed.indicators;
    const bool explains = indicators.refinementMm <= maxRefinementMm && assessed.metrics.coverage >= mostlyExplained;
    const auto withdrawn = explains ? 0 : std::erase_if(assessed.warnings, [](const Message& said) {
        return said.is(messages::singlePathVisible);
    });
    if (withdrawn > 0 && std::ranges::none_of(assessed.warnings, lowersConfidence)) {
        assessed.warnings.insert(assessed.warnings.begin(),
                                 messages::agreementTooLow(Quantity{100.0 * indicators.treeFraction, 0, "%"},
                                                           Quantity{100.0 * assessed.metrics.coverage, 0, "%"}));
    }
}

}   // namespace

Result<RegistrationResult> evaluatePose(const RegistrationInput& input, const RigidTransform& cameraFromPatient)
{
    if (!isRigid(cameraFromPatient)) {
        return Error(messages::evaluatedPoseNotRigid());
    }
    const RegistrationOptions options;
    const Result<RegistrationProblem> problem = makeProblem(input, options);
    if (!problem) {
        return problem.error();
    }
    MethodSolution solution;
    solution.cameraFromPatient = cameraFromPatient;
    solution.stopReason = StopReason::Converged;
    RegistrationResult assessed = assessPose(problem.value(), options, solution);
    withdrawSinglePath(assessed);
    return assessed;
}

}   // namespace angiopose::core

#include "core/registration/registration.h"

#include "core/messages/messages.h"
#include "core/registration/deformation_check.h"
#include "core/registration/held_depth.h"
#include "core/registration/image_orientation_check.h"
#include "core/registration/judging/judge_pose.h"
#include "core/registration/judging/within_2mm.h"
#include "core/registration/methods/method.h"
#include "core/registration/wire/judge_by_wire.h"
#include "core/support/stopwatch.h"

#include <algorithm>

namespace angiopose::core {

namespace {

// Chosen on synthetic data (DECISIONS D73): gives fewer false alarms and fewer undetected errors than rules alone.
constexpr double allButSure = 0.99;
constexpr double oftenFails = 0.8;

/// Rules of thumb that the calibrated probability may override; it must not override findings about other poses or
/// other frames.
bool isRuleOfThumb(const Message& said)
{
    return said.is(messages::trustFilledDoubtful) || said.is(messages::trustLittleAgreement) ||
           said.is(messages::trustLittleExplained) || said.is(messages::trustBetterAside) ||
           said.is(messages::trustPoseUncertain);
}

bool onlyRulesOfThumbSpeakAgainst(const RegistrationResult& result)
{
    const bool isOff = result.deformed && putsOverlayOff(*result.deformed);
    const bool isHeard = std::ranges::any_of(result.warnings, speaksAgainstTrust);
    return !isOff && isHeard && std::ranges::all_of(result.warnings, [](const Message& said) {
        return !speaksAgainstTrust(said) || isRuleOfThumb(said);
    });
}

/// Calibrates the confidence of a single-view result of the default method: adds the probability that its overlay lies
/// within 2 mm of the vessels, learned from many fits, and adjusts the confidence where it is conclusive (ALGORITHMS
/// §6.21). A nearly certain fit is reliable even if agreement or opacification is low; a fit of a kind that often fails
/// is not. If other signs count against a fit, a high probability is not reported.
void calibrateConfidence(RegistrationResult& result)
{
    const double probability = overlayProbability(result);
    result.probabilityWithin2Mm = probability;
    if (!result.trustworthy && probability >= allButSure && onlyRulesOfThumbSpeakAgainst(result)) {
        std::erase_if(result.warnings, isRuleOfThumb);
        result.trustworthy = true;
    }
    if (result.trustworthy && probability < oftenFails) {
        result.trustworthy = false;
        result.warnings.insert(result.warnings.begin(),
                               messages::trustOftenFails(Quantity{100.0 * probability, 0, "%"}));
    }
    if (!result.trustworthy &&
        probability >= oftenFails) {   // the probability does not account for the signs against this fit
        result.probabilityWithin2Mm.reset();
    }
}

/// Assesses a fit of the default method, however it was found: constrains a depth that the image does not determine,
/// unless branches were chosen to determine it, and reports a frame that may be mirrored or rotated. If stopped by the
/// user, keeps the pose as unreliable, because the assessment is incomplete.
RegistrationResult judgeWithCare(const RegistrationProblem& problem, const RegistrationOptions& options,
                                 const MethodSolution& solution, ProgressLog& progress)
{
    RegistrationResult result = judgePose(problem, options, solution);
    const auto held =
        solution.isSettled ? withDepthHeld(problem, options, solution, result) : std::optional<MethodSolution>();
    if (held) {
        result = judgePose(problem, options, *held);
    }
    const ImageOrientationCheck doubt =
        checkImageOrientation(problem, options, solution, result, [&](double) { return progress.askAgain(); });
    if (progress.isStopped()) {
        result.stopReason = StopReason::StoppedByUser;
        result.trustworthy = false;
    }
    if (doubt.message) {
        result.warnings.insert(result.warnings.begin(), *doubt.message);
        result.trustworthy = result.trustworthy && !doubt.shakesTrust;
    }
    return result;
}

bool isDeformationRequested(const RegistrationProblem& problem, const RegistrationOptions& options,
                            const MethodSolution& solution, const RegistrationResult& result)
{
    if (result.stopReason == StopReason::StoppedByUser || options.deformation != Deformation::Auto) {
        return result.stopReason != StopReason::StoppedByUser && options.deformation == Deformation::Always;
    }
    if (!solution.wantsCare || isAnyLocked(options.locks)) {
        return false;
    }
    return result.unopacified.empty() ? looksDeformed({problem, *solution.targetLines, result.cameraFromPatient})
                                      : looksDeformed({partOf(problem, solution.isOpacified), *solution.targetLines,
                                                       result.cameraFromPatient});
}

/// Branches that appear unopacified do not count as evidence of deformation.
DeformableView deformationView(const RegistrationInput& input, const RegistrationResult& result)
{
    DeformableView view{input, result.cameraFromPatient};
    for (const UnopacifiedBranch& branch : result.unopacified) {
        view.input.excludedBranchIds.push_back(branch.branchId);
    }
    return view;
}

}   // namespace

Result<RegistrationResult> registerVessels(const RegistrationInput& input, const RegistrationOptions& options,
                                           const IterationObserver& observe)
{
    Stopwatch stopwatch;
    if (const auto unusable = findProblem(options)) {
        return Error(*unusable);
    }
    const Result<RegistrationProblem> problem = makeProblem(input, options);
    if (!problem) {
        return problem.error();
    }
    ProgressLog progress(problem.value(), observe);
    const MethodSolution solution = findMethod(options.method)->solve(problem.value(), options, progress);

    RegistrationResult result = solution.wantsCare ? judgeWithCare(problem.value(), options, solution, progress)
                                                   : judgePose(problem.value(), options, solution);
    if (solution.wire) {
        judgeByWire(problem.value(), *solution.wire, result);
    }
    if (isDeformationRequested(problem.value(), options, solution, result)) {
        const DeformableView view = deformationView(input, result);
        result.deformed = judgeByDeformation({&view, 1}, deformationOptions(options),
                                             {result.uncertainty, result.trustworthy, result.warnings},
                                             [&](const IterationReport&) { return progress.askAgain("bending"); });
        result.stopReason = progress.isStopped() ? StopReason::StoppedByUser : result.stopReason;
    }
    if (solution.wantsCare && result.stopReason != StopReason::StoppedByUser) {
        calibrateConfidence(result);
    }
    result.method = options.method;
    result.history = progress.history();
    result.time.totalMs = stopwatch.lapMs();
    return result;
}

std::string_view toText(StopReason reason)
{
    switch (reason) {
        case StopReason::Converged:
            return "converged";
        case StopReason::IterationLimit:
            return "iteration limit";
        case StopReason::NoImprovement:
            return "no improvement";
        case StopReason::StoppedByUser:
            return "stopped by the user";
    }
    return "";
}

}   // namespace angiopose::core
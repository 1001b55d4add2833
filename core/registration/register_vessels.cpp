#include "core/registration/registration.h"

#include "core/messages/messages.h"
#include "core/registration/deformation_check.h"
#include "core/registration/depth_constraint.h"
#include "core/registration/image_orientation_check.h"
#include "core/registration/judging/assess_pose.h"
#include "core/registration/judging/distance_metrics.h"
#include "core/registration/judging/pose_shift.h"
#include "core/registration/judging/pose_uncertainty.h"
#include "core/registration/judging/within_2mm.h"
#include "core/registration/methods/method.h"
#include "core/registration/wire/find_wire_path.h"
#include "core/support/stopwatch.h"

#include <algorithm>

namespace angiopose::core {

namespace {

// Thresholds for the wire method, chosen on synthetic trees (wire_table --world made-up).
constexpr double sureProbability = 0.9;
constexpr double minReportedProbability = 0.05;   // minimum probability of an alternative path to report
constexpr double minFollowed = 0.7;   // minimum fraction of the wire that follows the tree
constexpr double maxGaps = 0.2;
constexpr double maxExpectedErrorMm = 2.2;   // errors have an RMS of 0.85 times this; below it, 5 % exceed 3 mm
constexpr double observedShare = 0.5;   // maximum σ of an observed parameter, relative to the prior

Quantity percent(double share)
{
    return {100.0 * share, 0, "%"};
}

std::vector<std::string> namesOf(const WirePath& path)
{
    std::vector<std::string> names;
    for (const int id : path.branchIds) {
        names.push_back(std::to_string(id));
    }
    return names;
}

Messages wireWarnings(const WireResult& finding, const RegistrationResult& result)
{
    Messages reasons;
    const WirePath& best = finding.paths.front();
    if (best.probability < sureProbability) {
        if (finding.paths.size() > 1 && finding.paths[1].probability >= minReportedProbability) {
            reasons.push_back(
                messages::wireAlternativePath(namesOf(finding.paths[1]), percent(finding.paths[1].probability)));
        } else {
            reasons.push_back(messages::wireUnlikely(percent(best.probability)));
        }
    }
    if (best.followedShare < minFollowed) {
        reasons.push_back(messages::wireOffTree(percent(best.followedShare)));
    }
    if (finding.gapFraction > maxGaps) {
        reasons.push_back(messages::wireFragmented(percent(finding.gapFraction)));
    }
    if (result.indicators.expectedErrorMm > maxExpectedErrorMm) {
        reasons.push_back(messages::poseUncertain(inMm(result.indicators.expectedErrorMm, 1)));
    }
    if (result.stopReason == StopReason::StoppedByUser) {
        reasons.push_back(messages::registrationStopped());
    }
    return reasons;
}

/// Measures distances along the best path only, because the rest of the tree is not visible.
void measureAlongPath(const RegistrationProblem& problem, const WireResult& finding, RegistrationResult& result)
{
    if (std::ranges::count(finding.isFollowed, std::uint8_t{1}) == 0) {
        return;
    }
    const RegistrationProblem way = restrictProblem(problem, finding.isFollowed);
    const GridIndex target(problem.target.points);
    result.metrics = distanceMetrics(way, result.cameraFromPatient, projectTree(way, result.cameraFromPatient, target));
}

/// Replaces the assessment for vessels by one for a wire: distances along the wire's path, a covariance that includes
/// the uncertainty of the path, confidence, messages and ranked paths.
void assessWire(const RegistrationProblem& problem, const WireResult& finding, RegistrationResult& result)
{
    result.wirePaths = finding.paths;
    result.camera.reset();
    result.warnings = problem.notes;
    if (finding.paths.empty()) {
        result.trustworthy = false;
        result.warnings.insert(result.warnings.begin(), result.stopReason == StopReason::StoppedByUser
                                                            ? messages::registrationStopped()
                                                            : messages::wireNoMatch());
        return;
    }
    replaceImageCovariance(result.uncertainty, finding.covariance, problem.tree.spreadMm);
    for (int k = 0; k < 6; ++k) {
        const double std = std::sqrt(std::max(0.0, finding.covariance(k, k)));
        result.uncertainty.observed[static_cast<std::size_t>(k)] = std < observedShare * finding.initialStd[k];
    }
    result.indicators.expectedErrorMm = expectedShiftMm(problem, result.cameraFromPatient, result.uncertainty);
    measureAlongPath(problem, finding, result);
    if (!finding.hasRequestedPath) {
        result.warnings.push_back(messages::wireFewerPaths(std::to_string(finding.paths.size())));
    }
    const Messages reasons = wireWarnings(finding, result);
    result.trustworthy = reasons.empty();
    result.warnings.insert(result.warnings.end(), reasons.begin(), reasons.end());
    if (!result.uncertainty.observed[5]) {
        result.warnings.push_back(messages::depthUndetermined());
    }
    const WirePath& best = finding.paths.front();
    result.warnings.push_back(
        messages::wirePath(namesOf(best), percent(best.probability), inMm(best.offAxisMm, 1)).as(Severity::Note));
}

// Chosen on synthetic data (DECISIONS D73): gives fewer false alarms and fewer undetected errors than rules alone.
constexpr double nearlyCertain = 0.99;
constexpr double minReliable = 0.8;

/// Whether a message results from a rule of thumb that the calibrated probability may override. The probability must
/// not override findings about other poses or image orientations.
bool isRuleOfThumb(const Message& said)
{
    return said.is(messages::opacificationUncertain) || said.is(messages::agreementTooLow) ||
           said.is(messages::tooLittleExplained) || said.is(messages::betterFitNearby) ||
           said.is(messages::poseUncertain);
}

bool hasOnlyRuleOfThumbWarnings(const RegistrationResult& result)
{
    const bool isOff = result.deformed && makesOverlayUnreliable(*result.deformed);
    const bool hasFindings = std::ranges::any_of(result.warnings, lowersConfidence);
    return !isOff && hasFindings && std::ranges::all_of(result.warnings, [](const Message& said) {
        return !lowersConfidence(said) || isRuleOfThumb(said);
    });
}

/// Calibrates the confidence of a single-view result of the default method (ALGORITHMS §6.21): adds the probability,
/// learned from many fits, that the overlay lies within 2 mm of the vessels, and changes the confidence where this
/// probability is conclusive. A nearly certain fit is reliable even if agreement or opacification is low; a fit of a
/// kind that often fails is not. If other findings count against a fit, a high probability is not reported.
void calibrateConfidence(RegistrationResult& result)
{
    const double probability = overlayProbability(result);
    result.probabilityWithin2Mm = probability;
    if (!result.trustworthy && probability >= nearlyCertain && hasOnlyRuleOfThumbWarnings(result)) {
        std::erase_if(result.warnings, isRuleOfThumb);
        result.trustworthy = true;
    }
    if (result.trustworthy && probability < minReliable) {
        result.trustworthy = false;
        result.warnings.insert(result.warnings.begin(),
                               messages::similarFitsOftenFail(Quantity{100.0 * probability, 0, "%"}));
    }
    if (!result.trustworthy && probability >= minReliable) {   // the probability ignores the problems found
        result.probabilityWithin2Mm.reset();
    }
}

/// Assesses a fit of the default method: constrains a depth that the image does not determine, unless the user selected
/// auxiliary branches to determine it, and reports an image that may be mirrored or rotated. If the user stops, keeps
/// the pose but marks it as unreliable, because the assessment is incomplete.
RegistrationResult assessFit(const RegistrationProblem& problem, const RegistrationOptions& options,
                             const MethodSolution& solution, ProgressLog& progress)
{
    RegistrationResult result = assessPose(problem, options, solution);
    const auto held =
        solution.isFullyRefined ? constrainDepth(problem, options, solution, result) : std::optional<MethodSolution>();
    if (held) {
        result = assessPose(problem, options, *held);
    }
    const ImageOrientationCheck check =
        checkImageOrientation(problem, options, solution, result, [&](double) { return progress.checkForStop(); });
    if (progress.isStopped()) {
        result.stopReason = StopReason::StoppedByUser;
        result.trustworthy = false;
    }
    if (check.message) {
        result.warnings.insert(result.warnings.begin(), *check.message);
        result.trustworthy = result.trustworthy && !check.invalidatesFit;
    }
    return result;
}

bool isDeformationRequested(const RegistrationProblem& problem, const RegistrationOptions& options,
                            const MethodSolution& solution, const RegistrationResult& result)
{
    if (result.stopReason == StopReason::StoppedByUser || options.deformation != Deformation::Auto) {
        return result.stopReason != StopReason::StoppedByUser && options.deformation == Deformation::Always;
    }
    if (!solution.needsChecks || isAnyLocked(options.locks)) {
        return false;
    }
    return result.unopacified.empty() ? looksDeformed({problem, *solution.targetLines, result.cameraFromPatient})
                                      : looksDeformed({restrictProblem(problem, solution.isOpacified),
                                                       *solution.targetLines, result.cameraFromPatient});
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

    RegistrationResult result = solution.needsChecks ? assessFit(problem.value(), options, solution, progress)
                                                     : assessPose(problem.value(), options, solution);
    if (solution.wire) {
        assessWire(problem.value(), *solution.wire, result);
    }
    if (isDeformationRequested(problem.value(), options, solution, result)) {
        const DeformableView view = deformationView(input, result);
        result.deformed = deformAndAssess({&view, 1}, deformationOptions(options),
                                          {result.uncertainty, result.trustworthy, result.warnings},
                                          [&](const IterationReport&) { return progress.checkForStop("bending"); });
        result.stopReason = progress.isStopped() ? StopReason::StoppedByUser : result.stopReason;
    }
    if (solution.needsChecks && result.stopReason != StopReason::StoppedByUser) {
        calibrateConfidence(result);
    }
    result.method = options.method;
    result.history = progress.history();
    result.time.totalMs = stopwatch.takeLapMs();
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

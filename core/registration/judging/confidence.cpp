#include "core/registration/judging/confidence.h"

#include "core/messages/messages.h"
#include "core/registration/judging/pose_shift.h"
#include "core/registration/judging/pose_uncertainty.h"

#include <cmath>

namespace angiopose::core {
namespace {

// Thresholds that separate poses within 2 mm from others, measured for several methods on simulated angiograms
// processed by the full tracing pipeline (ALGORITHMS §4.4).
constexpr double minAgreement = 0.37;   // harmonic mean of the explained fractions of tree and traced vessels
// The same threshold for the apparently opacified parts of a tree. It is higher because these parts were selected by
// their agreement. Measured on synthetic trees (foreign_targets_table --family development).
constexpr double minOpacifiedAgreement = 0.55;
constexpr int minOpacifiedBifurcations = 2;   // because a catheter or a single vessel fits many positions
constexpr double maxRefinementMm = 1.3;
constexpr double maxExpectedErrorMm = 1.2;
constexpr double maxAlternativeMm = 2.0;   // alternatives closer than this are clinically equivalent
constexpr double minInView = 0.4;   // minimum fraction of the tree points inside the image
// Wrong poses match up to 0.3 of the tree inside the image; correct poses of trees that extend beyond the image match
// 0.47 or more.
constexpr double convincingShare = 0.4;
constexpr int convincingBranches = 4;
constexpr double wellFollowedShare =
    0.8;   // fraction of the tree on vessels above which other vessels in the image explain low agreement
constexpr double stayedInDepthMm = 5.0;   // depth change up to which the depth counts as unchanged
constexpr double maxRotationStdDeg = 3.0;
constexpr double maxInPlaneStdMm = 3.0;

Quantity percent(double share)
{
    return {100.0 * share, 0, "%"};
}

/// Returns the low-agreement warning; a tree that lies on vessels but covers few is another tree or in a wrong unit.
Message littleAgreement(double shareOfTree, double shareOfVessels)
{
    return shareOfTree >= wellFollowedShare ? messages::tooLittleExplained(percent(shareOfVessels))
                                            : messages::agreementTooLow(percent(shareOfTree), percent(shareOfVessels));
}

/// Whether the visible part of the tree runs along traced vessels, however much lies outside the image.
bool followsVessels(const FitIndicators& indicators)
{
    return indicators.followedShare >= convincingShare && indicators.followedBranches >= convincingBranches;
}

void checkFit(const FitIndicators& indicators, double coverage, Messages& reasons)
{
    const bool isDoubtful = indicators.inViewFraction < minInView || indicators.agreement < minAgreement;
    if (isDoubtful && !followsVessels(indicators)) {
        if (indicators.inViewFraction < minInView) {
            reasons.push_back(messages::treeOutsideImage(percent(indicators.inViewFraction)));
        }
        if (indicators.agreement < minAgreement) {
            reasons.push_back(littleAgreement(indicators.treeFraction, coverage));
        }
    }
    const bool hasTooFewBifurcations =
        indicators.opacifiedBifurcations < minOpacifiedBifurcations && !(indicators.isSinglePath && indicators.isLumen);
    if (indicators.isPartlyOpacified && (indicators.agreement < minOpacifiedAgreement || hasTooFewBifurcations)) {
        reasons.push_back(messages::opacificationUncertain());
    }
    if (indicators.isSinglePath && !indicators.isLumen) {
        reasons.push_back(messages::singlePathVisible());
    }
    if (indicators.refinementMm > maxRefinementMm) {
        reasons.push_back(messages::betterFitNearby(inMm(indicators.refinementMm, 1)));
    }
}

/// Reports the contribution of camera errors, which does not count against a fit.
void checkUncertainty(const PoseUncertainty& uncertainty, Messages& reasons)
{
    const auto& observed = uncertainty.observed;
    const PoseSigmas sigmas = sigmasOf(uncertainty.imageCovariance);
    if (!observed[0] || !observed[1] || sigmas.rotationDeg.head<2>().maxCoeff() > maxRotationStdDeg) {
        reasons.push_back(messages::tiltUncertain());
    }
    if (!observed[2] || sigmas.rotationDeg.z() > maxRotationStdDeg) {
        reasons.push_back(messages::inPlaneRotationUncertain());
    }
    if (!observed[3] || !observed[4] || sigmas.inPlaneMm > maxInPlaneStdMm) {
        reasons.push_back(messages::shiftAlongVesselsUncertain());
    }
}

}   // namespace

ConfidenceAssessment assessConfidence(const RegistrationProblem& problem, const RegistrationResult& result)
{
    const FitIndicators& indicators = result.indicators;
    ConfidenceAssessment confidence;
    checkFit(indicators, result.metrics.coverage, confidence.warnings);
    checkUncertainty(result.uncertainty, confidence.warnings);
    if (indicators.expectedErrorMm > maxExpectedErrorMm) {
        confidence.warnings.push_back(messages::poseUncertain(inMm(indicators.expectedErrorMm, 1)));
    }
    if (indicators.alternativeMm > maxAlternativeMm) {
        confidence.warnings.push_back(messages::alternativePoseFits());
    }
    if (result.stopReason == StopReason::StoppedByUser) {
        confidence.warnings.push_back(messages::registrationStopped());
    }
    confidence.isTrustworthy = confidence.warnings.empty();
    if (!result.uncertainty.observed[5]) {
        const double movedMm = std::abs(depthShiftMm(problem, result.cameraFromPatient));
        confidence.warnings.push_back(movedMm < stayedInDepthMm ? messages::depthUndetermined()
                                                                : messages::depthChangeUndetermined(inMm(movedMm, 0)));
    }
    return confidence;
}

}   // namespace angiopose::core

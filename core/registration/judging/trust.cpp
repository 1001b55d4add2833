#include "core/registration/judging/trust.h"

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
constexpr double minFilledAgreement = 0.55;
constexpr int minFilledForks = 2;   // because a catheter or a single vessel fits many positions
constexpr double maxSettlingMm = 1.3;
constexpr double maxExpectedErrorMm = 1.2;
constexpr double maxRivalMm = 2.0;   // alternatives closer than this are clinically equivalent
constexpr double minInView = 0.4;   // minimum fraction of the tree points inside the image
// Wrong poses match up to 0.3 of the tree inside the image; correct poses of trees that extend beyond the image match
// 0.47 or more.
constexpr double convincingShare = 0.4;
constexpr int convincingBranches = 4;
constexpr double wellFollowedShare =
    0.8;   // fraction of the tree on vessels above which other vessels in the image explain low agreement
constexpr double stayedInDepthMm = 5.0;   // depth change below which the depth counts as unchanged
constexpr double maxRotationStdDeg = 3.0;
constexpr double maxInPlaneStdMm = 3.0;

Quantity percent(double share)
{
    return {100.0 * share, 0, "%"};
}

/// Returns the low-agreement warning; a tree on vessels that covers few of them is another tree or in a wrong unit.
Message littleAgreement(double shareOfTree, double shareOfVessels)
{
    return shareOfTree >= wellFollowedShare
               ? messages::trustLittleExplained(percent(shareOfVessels))
               : messages::trustLittleAgreement(percent(shareOfTree), percent(shareOfVessels));
}

/// Whether the visible part of the tree runs along traced vessels, however much lies outside the image.
bool followsVessels(const FitSigns& signs)
{
    return signs.followedShare >= convincingShare && signs.followedBranches >= convincingBranches;
}

void judgeFit(const FitSigns& signs, double coverage, Messages& reasons)
{
    const bool isDoubtful = signs.inViewShare < minInView || signs.agreement < minAgreement;
    if (isDoubtful && !followsVessels(signs)) {
        if (signs.inViewShare < minInView) {
            reasons.push_back(messages::trustOutsideImage(percent(signs.inViewShare)));
        }
        if (signs.agreement < minAgreement) {
            reasons.push_back(littleAgreement(signs.treeShare, coverage));
        }
    }
    const bool forksTooLittle = signs.filledForks < minFilledForks && !(signs.isSinglePath && signs.isLumen);
    if (signs.isPartlyOpacified && (signs.agreement < minFilledAgreement || forksTooLittle)) {
        reasons.push_back(messages::trustFilledDoubtful());
    }
    if (signs.isSinglePath && !signs.isLumen) {
        reasons.push_back(messages::trustSinglePath());
    }
    if (signs.settlingMm > maxSettlingMm) {
        reasons.push_back(messages::trustBetterAside(inMm(signs.settlingMm, 1)));
    }
}

/// Reports the contribution of camera errors, which does not count against a fit.
void judgeUncertainty(const PoseUncertainty& uncertainty, Messages& reasons)
{
    const auto& observed = uncertainty.observed;
    const PoseSigmas sigmas = sigmasOf(uncertainty.imageCovariance);
    if (!observed[0] || !observed[1] || sigmas.rotationDeg.head<2>().maxCoeff() > maxRotationStdDeg) {
        reasons.push_back(messages::trustTiltUncertain());
    }
    if (!observed[2] || sigmas.rotationDeg.z() > maxRotationStdDeg) {
        reasons.push_back(messages::trustTurnUncertain());
    }
    if (!observed[3] || !observed[4] || sigmas.inPlaneMm > maxInPlaneStdMm) {
        reasons.push_back(messages::trustShiftUncertain());
    }
}

}   // namespace

Trust judgeTrust(const RegistrationProblem& problem, const RegistrationResult& result)
{
    const FitSigns& signs = result.signs;
    Trust trust;
    judgeFit(signs, result.metrics.coverage, trust.warnings);
    judgeUncertainty(result.uncertainty, trust.warnings);
    if (signs.expectedErrorMm > maxExpectedErrorMm) {
        trust.warnings.push_back(messages::trustPoseUncertain(inMm(signs.expectedErrorMm, 1)));
    }
    if (signs.rivalMm > maxRivalMm) {
        trust.warnings.push_back(messages::trustRival());
    }
    if (result.stopReason == StopReason::StoppedByUser) {
        trust.warnings.push_back(messages::trustStopped());
    }
    trust.isTrustworthy = trust.warnings.empty();
    if (!result.uncertainty.observed[5]) {
        const double movedMm = std::abs(depthShiftMm(problem, result.cameraFromPatient));
        trust.warnings.push_back(movedMm < stayedInDepthMm ? messages::trustDepthUnknown()
                                                           : messages::trustDepthMoved(inMm(movedMm, 0)));
    }
    return trust;
}

}   // namespace angiopose::core

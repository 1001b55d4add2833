#include "core/registration/deformation_check.h"

#include "core/messages/messages.h"
#include "core/registration/alignment/alignment_points.h"
#include "core/registration/alignment/shape_tolerance.h"
#include "core/registration/judging/pose_uncertainty.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

namespace angiopose::core {
namespace {

// Measured on synthetic trees from three generators (bent_trust_table and foreign_targets_table --family development,
// the simulator's degraded targets): rigid trees with a fifth of the branches missing stay below 0.29 px offset and
// above 0.57 of the visible length; trees deformed by 1 mm or more lie above 0.5 px or below 0.48.
constexpr double minOffsetPx = 0.4;   // standard deviation of stretch offsets above which a fit looks deformed
constexpr double minFoundShare = 0.52;   // matched fraction of the visible tree below which a fit looks deformed
constexpr double maxRigidOffMm = 1.9;   // expected error of the tree's points; errors from 2 mm on must be flagged

/// Returns the fraction of the tree inside the image that lies along traced vessels.
double foundShare(const Alignment& alignment, const CentroidPose& pose)
{
    constexpr double scalePx = 2.0;
    std::vector<double> agreement;
    alignment.collectAgreement(pose, scalePx, agreement);
    double found = 0.0;
    double visible = 0.0;
    for (const double share : agreement) {
        if (std::isfinite(share)) {
            found += share;
            visible += 1.0;
        }
    }
    return visible > 0.0 ? found / visible : 1.0;
}

/// Whether deformation alone explains a warning about a rigid fit.
bool isExplained(const Message& reason)
{
    return reason.is(messages::agreementTooLow) || reason.is(messages::betterFitNearby) ||
           reason.is(messages::poseUncertain);
}

/// Withdraws the fit warnings that a certain but small deformation explains.
void withdrawExplained(RigidAssessment assessment)
{
    if (std::erase_if(assessment.warnings, isExplained) > 0) {
        assessment.trustworthy = std::ranges::none_of(assessment.warnings, lowersConfidence);
    }
}

/// Returns the display name of a branch: its label or, if it has none, its number.
std::string nameOrNumber(const VesselTree& tree, int branchId)
{
    const VesselBranch* branch = tree.find(branchId);
    return branch && !branch->name.empty() ? branch->name : std::to_string(branchId);
}

/// Returns a message about the error of the rigid overlay, worded according to how certain the deformation is.
Message overlayErrorMessage(const DeformableResult& deformed, const VesselTree& tree)
{
    const Quantity mean = inMm(deformed.rigid.meanMm, 1);
    const Quantity farthest = inMm(deformed.rigid.farthestMm, 1);
    const std::string branch = nameOrNumber(tree, deformed.rigid.farthestBranchId);
    return deformed.verdict == DeformationVerdict::Deformed ? messages::deformationRigidOff(mean, farthest, branch)
                                                            : messages::deformationMayBeOff(mean, farthest, branch);
}

/// Lowers the confidence if the rigid overlay is too far off; withdraws the warnings that a small deformation explains.
/// Always reports the overlay error, first among the warnings if it is certain.
void reportDeformation(const DeformableResult& deformed, const VesselTree& tree, RigidAssessment assessment)
{
    const bool isOff = makesOverlayUnreliable(deformed);
    if (deformed.verdict == DeformationVerdict::Deformed && !isOff) {
        withdrawExplained(assessment);
    }
    assessment.trustworthy = assessment.trustworthy && !isOff;
    Messages said{overlayErrorMessage(deformed, tree).as(isOff ? Severity::Warning : Severity::Note)};
    std::ranges::copy_if(deformed.messages, std::back_inserter(said),
                         [](const Message& message) { return !message.is(messages::deformationDepthUnknown); });
    const auto place = isOff && deformed.verdict == DeformationVerdict::Deformed ? assessment.warnings.begin()
                                                                                 : assessment.warnings.end();
    assessment.warnings.insert(place, said.begin(), said.end());
}

}   // namespace

DeformableOptions deformationOptions(const RegistrationOptions& options)
{
    DeformableOptions deformation;
    deformation.startDeg = options.angiopose.priorRotationDeg;
    deformation.startLateralMm = options.angiopose.priorLateralMm;
    deformation.startDepthMm = options.angiopose.priorDepthMm;
    return deformation;
}

bool makesOverlayUnreliable(const DeformableResult& deformed)
{
    return deformed.verdict != DeformationVerdict::Rigid &&
           std::hypot(deformed.rigid.meanMm, deformed.placeStdMm) > maxRigidOffMm;
}

bool lowersConfidence(const Message& said)
{
    const std::string_view id = said.id();
    const bool isKnown = said.is(messages::depthUndetermined) || said.is(messages::depthChangeUndetermined) ||
                         said.is(messages::treePartlyOpacified) || said.is(messages::fewBranchesOpacified);
    return (id.starts_with("trust.") && !isKnown) || id.starts_with("frame.") || id.starts_with("views.");
}

bool looksDeformed(const RigidFit& fit)
{
    const CentroidPose pose = aboutCentroid(fit.cameraFromPatient, fit.problem.tree.centroid);
    const double depthMm = std::max(minProjectableDepthMm, pose.centroidInCamera.z());
    const Alignment alignment(informativePoints(fit.problem.tree, millimetersPerPixel(fit.problem.camera, depthMm)),
                              fit.problem.camera, fit.target);
    return estimateOffset(alignment, pose) > minOffsetPx || foundShare(alignment, pose) < minFoundShare;
}

std::shared_ptr<const DeformableResult> deformAndAssess(std::span<const DeformableView> views,
                                                        const DeformableOptions& options, RigidAssessment assessment,
                                                        const IterationObserver& observe)
{
    auto deformed = deformVessels(views, options, observe);
    if (!deformed) {
        return nullptr;
    }
    auto result = std::make_shared<const DeformableResult>(std::move(deformed).value());
    if (result->stopReason == StopReason::StoppedByUser) {   // the check is incomplete, and the fit had looked deformed
        assessment.trustworthy = false;
        assessment.warnings.insert(assessment.warnings.begin(), messages::deformationStopped().as(Severity::Warning));
    } else if (result->verdict != DeformationVerdict::Rigid) {
        const Matrix6d covariance = result->rigid.covariance + result->rigid.step * result->rigid.step.transpose();
        replaceImageCovariance(assessment.uncertainty, covariance, result->rigid.spreadMm);
        reportDeformation(*result, views.front().input.tree, assessment);
    }
    return result;
}

}   // namespace angiopose::core

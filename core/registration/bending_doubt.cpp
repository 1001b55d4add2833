#include "core/registration/bending_doubt.h"

#include "core/messages/says.h"
#include "core/registration/alignment/alignment_points.h"
#include "core/registration/alignment/shape_tolerance.h"
#include "core/registration/judging/pose_uncertainty.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

namespace angiopose::core {
namespace {

// Measured on made-up trees by three generators (bent_trust_table and foreign_targets_table --family development, the
// simulator's degraded targets): rigid ones, a fifth of the branches missing, stay below 0.29 px and above 0.57 of
// their visible length; trees bent by 1 mm and more lie above 0.5 px or below 0.48.
constexpr double leastOffsetPx = 0.4;   // of stretches beside their vessels
constexpr double leastFoundShare = 0.52;   // of the visible tree: the rest may have moved away
constexpr double mostRigidOffMm = 1.9;   // to be expected of the tree's points; errors from 2 mm on shall be flagged

/// Share of the tree inside the image that lies along traced vessels.
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

/// What looks wrong about a rigid fit only because the vessels are bent.
bool isExplained(const Message& reason)
{
    return reason.is(says::trustLittleAgreement) || reason.is(says::trustBetterAside) ||
           reason.is(says::trustPoseUncertain);
}

/// A bend that is sure and small explains what spoke against the fit.
void withdrawExplained(RigidJudgement judgement)
{
    if (std::erase_if(judgement.warnings, isExplained) > 0) {
        judgement.trustworthy = std::ranges::none_of(judgement.warnings, speaksAgainstTrust);
    }
}

/// By which people know a branch: as it is labelled, else its number.
std::string nameOrNumber(const VesselTree& tree, int branchId)
{
    const VesselBranch* branch = tree.find(branchId);
    return branch && !branch->name.empty() ? branch->name : std::to_string(branchId);
}

/// How far the rigid overlay is off, as surely as the bend is known.
Message offWords(const DeformableResult& bent, const VesselTree& tree)
{
    const Quantity mean = inMm(bent.rigid.meanMm, 1);
    const Quantity farthest = inMm(bent.rigid.farthestMm, 1);
    const std::string branch = nameOrNumber(tree, bent.rigid.farthestBranchId);
    return bent.verdict == BendVerdict::Bent ? says::bendRigidOff(mean, farthest, branch)
                                             : says::bendMayBeOff(mean, farthest, branch);
}

/// Lets trust fall where the overlay is off, hold where the bend explains the rest; how far it is off is always said,
/// first where it is sure.
void tellBend(const DeformableResult& bent, const VesselTree& tree, RigidJudgement judgement)
{
    const bool isOff = putsOverlayOff(bent);
    if (bent.verdict == BendVerdict::Bent && !isOff) {
        withdrawExplained(judgement);
    }
    judgement.trustworthy = judgement.trustworthy && !isOff;
    Messages said{offWords(bent, tree).as(isOff ? Severity::Warning : Severity::Note)};
    std::ranges::copy_if(bent.messages, std::back_inserter(said),
                         [](const Message& message) { return !message.is(says::bendDepthUnknown); });
    const auto place =
        isOff && bent.verdict == BendVerdict::Bent ? judgement.warnings.begin() : judgement.warnings.end();
    judgement.warnings.insert(place, said.begin(), said.end());
}

}   // namespace

DeformableOptions bendingOptions(const RegistrationOptions& options)
{
    DeformableOptions bending;
    bending.startDeg = options.angiopose.priorRotationDeg;
    bending.startLateralMm = options.angiopose.priorLateralMm;
    bending.startDepthMm = options.angiopose.priorDepthMm;
    return bending;
}

bool putsOverlayOff(const DeformableResult& bent)
{
    return bent.verdict != BendVerdict::Rigid && std::hypot(bent.rigid.meanMm, bent.placeStdMm) > mostRigidOffMm;
}

bool speaksAgainstTrust(const Message& said)
{
    const std::string_view id = said.id();
    const bool isTold = said.is(says::trustDepthUnknown) || said.is(says::trustDepthMoved) ||
                        said.is(says::trustPartFilled) || said.is(says::trustFewFilled);
    return (id.starts_with("trust.") && !isTold) || id.starts_with("frame.") || id.starts_with("views.");
}

bool looksBent(const RigidFit& fit)
{
    const CentroidPose pose = aboutCentroid(fit.cameraFromPatient, fit.problem.tree.centroid);
    const double depthMm = std::max(minProjectableDepthMm, pose.centroidInCamera.z());
    const Alignment alignment(tellingPoints(fit.problem.tree, millimetresPerPixel(fit.problem.camera, depthMm)),
                              fit.problem.camera, fit.target);
    return likelyOffsetOf(alignment, pose) > leastOffsetPx || foundShare(alignment, pose) < leastFoundShare;
}

std::shared_ptr<const DeformableResult> judgeByBending(std::span<const DeformableView> views,
                                                       const DeformableOptions& options, RigidJudgement judgement,
                                                       const IterationObserver& observe)
{
    auto bent = deformVessels(views, options, observe);
    if (!bent) {
        return nullptr;
    }
    auto result = std::make_shared<const DeformableResult>(std::move(bent).value());
    if (result->stopReason == StopReason::StoppedByUser) {   // what looked bent stays in doubt
        judgement.trustworthy = false;
        judgement.warnings.insert(judgement.warnings.begin(), says::bendStopped().as(Severity::Warning));
    } else if (result->verdict != BendVerdict::Rigid) {
        const Matrix6d covariance = result->rigid.covariance + result->rigid.step * result->rigid.step.transpose();
        replaceImageCovariance(judgement.uncertainty, covariance, result->rigid.spreadMm);
        tellBend(*result, views.front().input.tree, judgement);
    }
    return result;
}

}   // namespace angiopose::core

#include "core/case/start_pose.h"

#include "core/messages/says.h"

namespace angiopose::core {
namespace {

Result<RigidTransform> poseFromAngles(const View& view, const Vessels& vessels)
{
    const auto& isocentre = view.geometry.cArm.isocentreInPatientMm.value;
    if (!isocentre && !vessels.tree) {
        return Error(says::noVesselTree());
    }
    return cameraFromPatient(cArmOfFrame(view), isocentre ? *isocentre : centroidInPatient(*vessels.tree));
}

}   // namespace

Result<RigidTransform> startPoseOf(const View& view, const Vessels& vessels)
{
    if (view.initialCameraFromPatient) {
        return *view.initialCameraFromPatient;
    }
    return poseFromAngles(view, vessels);
}

bool isAtStart(const View& view, const Vessels& vessels)
{
    const auto start = startPoseOf(view, vessels);
    return !view.result && start && view.cameraFromPatient.matrix().isApprox(start.value().matrix(), 1e-9);
}

View withFrame(View view, const Vessels& vessels, int frame)
{
    const auto before = poseFromAngles(view, vessels);
    view.frame = frame;
    if (const FollowedFrame* followed = findFrame(view.followed, frame)) {
        view.cameraFromPatient = followed->tracked.cameraFromPatient;
        view.result.reset();
        return view;
    }
    const bool turns = view.angiogram && !view.angiogram->gantry.angleIncrementsDeg.empty();
    const auto after = poseFromAngles(view, vessels);
    if (!turns || !before || !after) {
        return view;
    }
    const RigidTransform laterFromEarlier = after.value() * before.value().inverse();
    view.cameraFromPatient = laterFromEarlier * view.cameraFromPatient;
    if (view.initialCameraFromPatient) {
        view.initialCameraFromPatient = laterFromEarlier * *view.initialCameraFromPatient;
    }
    forgetFindings(view);
    return view;
}

Result<RigidTransform> viewFromView(const View& first, const View& view, const Vessels& vessels)
{
    const Eigen::Vector3d anyIsocentre = Eigen::Vector3d::Zero();   // the same for both: it cancels
    const auto gantryOfFirst = cameraFromPatient(cArmOfFrame(first), anyIsocentre);
    const auto gantry = cameraFromPatient(cArmOfFrame(view), anyIsocentre);
    if (gantryOfFirst && gantry) {
        return gantry.value() * gantryOfFirst.value().inverse();
    }
    const auto startOfFirst = startPoseOf(first, vessels);
    const auto start = startPoseOf(view, vessels);
    return startOfFirst && start ? Result<RigidTransform>(start.value() * startOfFirst.value().inverse())
           : start               ? startOfFirst.error()
                                 : start.error();
}

}   // namespace angiopose::core

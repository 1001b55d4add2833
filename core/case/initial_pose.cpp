#include "core/case/initial_pose.h"

#include "core/messages/messages.h"

namespace angiopose::core {
namespace {

Result<RigidTransform> poseFromAngles(const View& view, const Vessels& vessels)
{
    const auto& isocenter = view.geometry.cArm.isocenterInPatientMm.value;
    if (!isocenter && !vessels.tree) {
        return Error(messages::noVesselTree());
    }
    CArm cArm = cArmOfFrame(view);
    if (isocenter) {
        return cameraFromPatient(cArm, *isocenter);
    }
    cArm.sourceToIsocenterMm = vesselDepthOf(cArm);
    return cameraFromPatient(cArm, centroidInPatient(*vessels.tree));
}

}   // namespace

Result<RigidTransform> initialPoseOf(const View& view, const Vessels& vessels)
{
    if (view.initialCameraFromPatient) {
        return *view.initialCameraFromPatient;
    }
    return poseFromAngles(view, vessels);
}

bool isAtInitialPose(const View& view, const Vessels& vessels)
{
    const auto start = initialPoseOf(view, vessels);
    return !view.result && start && view.cameraFromPatient.matrix().isApprox(start.value().matrix(), 1e-9);
}

View withFrame(View view, int frame)
{
    const Eigen::Vector3d anyIsocenter = Eigen::Vector3d::Zero();   // same for both poses, so it cancels
    const auto before = cameraFromPatient(cArmOfFrame(view), anyIsocenter);
    view.frame = frame;
    if (const TrackedRunFrame* followed = findFrame(view.followed, frame)) {
        view.cameraFromPatient = followed->tracked.cameraFromPatient;
        view.result.reset();
        return view;
    }
    const bool turns = view.angiogram && !view.angiogram->gantry.angleIncrementsDeg.empty();
    const auto after = cameraFromPatient(cArmOfFrame(view), anyIsocenter);
    if (!turns || !before || !after) {
        return view;
    }
    const RigidTransform laterFromEarlier = after.value() * before.value().inverse();
    view.cameraFromPatient = laterFromEarlier * view.cameraFromPatient;
    if (view.initialCameraFromPatient) {
        view.initialCameraFromPatient = laterFromEarlier * *view.initialCameraFromPatient;
    }
    discardResults(view);
    return view;
}

}   // namespace angiopose::core

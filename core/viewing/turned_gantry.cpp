#include "core/viewing/turned_gantry.h"

namespace angiopose::core {
namespace {

const Eigen::Vector3d anyIsocentre = Eigen::Vector3d::Zero();   // before and after the turn the same: it cancels

}   // namespace

std::optional<GantryAngles> gantryAnglesOf(const View& view)
{
    const CArm cArm = cArmOfFrame(view);
    if (!cArm.primaryAngleDeg.value || !cArm.secondaryAngleDeg.value) {
        return {};
    }
    return GantryAngles{*cArm.primaryAngleDeg.value, *cArm.secondaryAngleDeg.value};
}

Result<PoseAtAngles> turningGantry(const View& view)
{
    const CArm now = cArmOfFrame(view);
    const auto gantry = cameraFromPatient(now, anyIsocentre);
    if (!gantry) {
        return gantry.error();
    }
    const RigidTransform gantryFromVessels = gantry.value().inverse() * view.cameraFromPatient;
    return PoseAtAngles([now, gantryFromVessels](const GantryAngles& angles) {
        CArm turned = now;
        turned.primaryAngleDeg.value = angles.primaryDeg;
        turned.secondaryAngleDeg.value = angles.secondaryDeg;
        return cameraFromPatient(turned, anyIsocentre).value() * gantryFromVessels;
    });
}

}   // namespace angiopose::core

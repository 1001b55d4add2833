#include "core/exchange/xreg_camera.h"

#include "core/exchange/projection_matrix.h"
#include "core/messages/says_exchange.h"

#include <Eigen/Geometry>
#include <cmath>

namespace angiopose::core {
namespace {

/// Half round the y axis: a detector at negative z comes to lie at positive z, where ours is.
Eigen::Matrix3d halfAboutY()
{
    return Eigen::Vector3d(-1.0, 1.0, -1.0).asDiagonal();
}

/// Both focal lengths by the pixel spacing, in the mean.
double focalLengthMm(const XregCamera& camera)
{
    return 0.5 * (std::abs(camera.intrinsic(0, 0)) * camera.columnSpacingMm +
                  std::abs(camera.intrinsic(1, 1)) * camera.rowSpacingMm);
}

/// Our frame from that of xReg with the intrinsic matrix that goes with ours.
struct FrameChange {
    RigidTransform oursFromXreg;
    Eigen::Matrix3d intrinsic;
};

FrameChange frameChange(const XregCamera& camera)
{
    FrameChange change{{}, camera.intrinsic};
    if (camera.frame == XregFrame::DetectorAtPositiveZ) {
        return change;
    }
    change.oursFromXreg.rotation = halfAboutY();
    if (camera.frame == XregFrame::DetectorAtNegativeZ) {   // x / z = X / Z, y / z = -Y / Z
        change.intrinsic.col(1) *= -1.0;
    } else {   // Z = f - z, x = -X, y = Y
        change.oursFromXreg.translation.z() = focalLengthMm(camera);
        change.intrinsic.col(0) *= -1.0;
    }
    return change;
}

Result<Sight> sightOfWorld(const XregCamera& camera)
{
    const FrameChange change = frameChange(camera);
    const RigidTransform pose = change.oursFromXreg * camera.cameraFromWorld;
    auto sight = sightFromIntrinsics(change.intrinsic, pose.rotation, pose.translation);
    if (!sight) {
        return sight;
    }
    Sight sized = sight.value();
    sized.camera.width = camera.columns;
    sized.camera.height = camera.rows;
    return sized;
}

}   // namespace

Result<Sight> sightFromXreg(const XregCamera& camera, const RigidTransform& volumeFromWorld)
{
    const auto world = sightOfWorld(camera);
    if (!world) {
        return world;
    }
    return Sight{world.value().camera, world.value().cameraFromPatient * volumeFromWorld.inverse()};
}

Result<RigidTransform> xregPose(const RigidTransform& cameraFromPatient, const XregCamera& camera)
{
    const auto world = sightOfWorld(camera);
    return world ? Result<RigidTransform>(cameraFromPatient.inverse() * world.value().cameraFromPatient)
                 : world.error();
}

XregCamera xregCamera(const ProjectionCamera& camera, double sourceToDetectorMm)
{
    XregCamera theirs;
    theirs.intrinsic = intrinsicMatrix(camera);
    theirs.columns = camera.width;
    theirs.rows = camera.height;
    theirs.columnSpacingMm = sourceToDetectorMm / std::abs(camera.fx);
    theirs.rowSpacingMm = sourceToDetectorMm / std::abs(camera.fy);
    theirs.frame = camera.fx < 0.0 ? XregFrame::DetectorAtNegativeZ : XregFrame::DetectorAtPositiveZ;
    if (theirs.frame == XregFrame::DetectorAtNegativeZ) {
        theirs.intrinsic(1, 1) *= -1.0;
    }
    return theirs;
}

}   // namespace angiopose::core

#include "core/geometry/pose_offset.h"

#include "core/geometry/angle_units.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

/// Signs of the camera axes x and y in the screen directions right and down.
struct ScreenSigns {
    double right;
    double down;
};

ScreenSigns screenSigns(const ProjectionCamera& camera)
{
    return {camera.fx < 0.0 ? -1.0 : 1.0, camera.fy < 0.0 ? -1.0 : 1.0};
}

/// Returns the rotation of the vessels in camera axes. C-arm rotation toward LAO is a positive rotation about +Y and
/// cranial angulation a negative one about +X (ALGORITHMS §5.3), however the image is displayed. Only the roll on
/// screen depends on the display.
Eigen::Matrix3d rotationFor(const PoseOffset& offset, const ScreenSigns& signs)
{
    const double roll = offset.rollDeg / degreesPerRadian * signs.right * signs.down;
    const double cra = -offset.craCauDeg / degreesPerRadian;
    const double lao = offset.laoRaoDeg / degreesPerRadian;
    return (Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(cra, Eigen::Vector3d::UnitX()) *
            Eigen::AngleAxisd(lao, Eigen::Vector3d::UnitY()))
        .toRotationMatrix();
}

}   // namespace

RigidTransform applyOffset(const RigidTransform& reference, const PoseOffset& offset,
                           const Eigen::Vector3d& pivotInPatient, const ProjectionCamera& camera)
{
    const ScreenSigns signs = screenSigns(camera);
    const Eigen::Vector3d shift(signs.right * offset.rightMm, -signs.down * offset.upMm, offset.alongRayMm);
    const Eigen::Matrix3d rotation = rotationFor(offset, signs) * reference.rotation;
    const Eigen::Vector3d pivotInCamera = reference * pivotInPatient + shift;
    return {rotation, pivotInCamera - rotation * pivotInPatient};
}

PoseOffset offsetBetween(const RigidTransform& reference, const RigidTransform& pose,
                         const Eigen::Vector3d& pivotInPatient, const ProjectionCamera& camera)
{
    const ScreenSigns signs = screenSigns(camera);
    const Eigen::Vector3d shift = pose * pivotInPatient - reference * pivotInPatient;
    const Eigen::Matrix3d r = pose.rotation * reference.rotation.transpose();

    // r = Rz(roll) Rx(cra) Ry(lao): bottom row (−cos cra sin lao, sin cra, cos cra cos lao), middle column Rz Rx e_y.
    const double cra = std::asin(std::clamp(r(2, 1), -1.0, 1.0));
    const double lao = std::atan2(-r(2, 0), r(2, 2));
    const double roll = std::atan2(-r(0, 1), r(1, 1));

    PoseOffset offset;
    offset.rightMm = signs.right * shift.x();
    offset.upMm = -signs.down * shift.y();
    offset.alongRayMm = shift.z();
    offset.rollDeg = roll * degreesPerRadian * signs.right * signs.down;
    offset.laoRaoDeg = lao * degreesPerRadian;
    offset.craCauDeg = -cra * degreesPerRadian;
    return offset;
}

}   // namespace angiopose::core

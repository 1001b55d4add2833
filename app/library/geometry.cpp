#include "angiopose/geometry.h"

#include "app/library/conversions.h"
#include "app/library/observer_adapter.h"

namespace angiopose::library {
namespace {

template <class T>
core::SourcedValue<T> givenBy(const std::optional<T>& value)
{
    return {value, value ? core::Origin::User : core::Origin::Missing, {}};
}

}   // namespace

core::RigidTransform toCore(const Pose& pose)
{
    const core::RigidTransform converted{pose.topLeftCorner<3, 3>(), pose.topRightCorner<3, 1>()};
    if (pose.row(3) != Pose::Identity().row(3) || !core::isRigid(converted)) {
        throw Error("library.no-pose",
                    "A pose must be a rigid motion: the 4 x 4 matrix that maps patient points to camera points, of "
                    "finite numbers, with an orthonormal rotation of determinant +1 and the last row 0, 0, 0, 1.");
    }
    return converted;
}

core::ProjectionCamera toCore(const ProjectionCamera& camera)
{
    const auto& [fx, fy, cx, cy, width, height] = camera;
    return {fx, fy, cx, cy, width, height};
}

core::CArm toCore(const CArm& cArm)
{
    core::CArm converted;
    converted.sourceToDetectorMm = givenBy(cArm.sourceToDetectorMm);
    converted.sourceToIsocenterMm = givenBy(cArm.sourceToPatientMm);
    converted.columnSpacingMm = givenBy(cArm.columnSpacingMm);
    converted.rowSpacingMm = givenBy(cArm.rowSpacingMm);
    converted.primaryAngleDeg = givenBy(cArm.primaryAngleDeg);
    converted.secondaryAngleDeg = givenBy(cArm.secondaryAngleDeg);
    converted.rollDeg = givenBy(cArm.rollDeg);
    if (cArm.principalPointUPx && cArm.principalPointVPx) {
        converted.principalPointPx =
            givenBy(std::optional(Eigen::Vector2d(*cArm.principalPointUPx, *cArm.principalPointVPx)));
    }
    converted.mirrored = givenBy(std::optional(cArm.mirrored));
    converted.isocenterInPatientMm = givenBy(cArm.isocenterInPatientMm);
    return converted;
}

Pose toPublic(const core::RigidTransform& transform)
{
    Pose pose = Pose::Identity();
    pose.topLeftCorner<3, 3>() = transform.rotation;
    pose.topRightCorner<3, 1>() = transform.translation;
    return pose;
}

ProjectionCamera toPublic(const core::ProjectionCamera& camera)
{
    const auto& [fx, fy, cx, cy, width, height] = camera;
    return {fx, fy, cx, cy, width, height};
}

CArm toPublic(const core::CArm& cArm)
{
    const auto& [detector, sourceToIsocenter, object, column, row, primary, secondary, roll, center, mirrored,
                 isocenter] = cArm;
    CArm converted{detector.value,
                   sourceToIsocenter.value,
                   column.value,
                   row.value,
                   primary.value,
                   secondary.value,
                   roll.value,
                   {},
                   {},
                   mirrored.value.value_or(false),
                   isocenter.value};
    if (center.value) {
        converted.principalPointUPx = center.value->x();
        converted.principalPointVPx = center.value->y();
    }
    return converted;
}

}   // namespace angiopose::library

namespace angiopose {

ProjectionCamera cameraFromCArm(const CArm& cArm, int width, int height)
{
    return library::toPublic(library::valueOf(core::cameraFromCArm(library::toCore(cArm), width, height)));
}

Pose cameraFromPatient(const CArm& cArm, const Eigen::Vector3d& isocenterInPatient)
{
    return library::toPublic(library::valueOf(core::cameraFromPatient(library::toCore(cArm), isocenterInPatient)));
}

std::optional<Eigen::Vector2d> project(const ProjectionCamera& camera, const Pose& cameraFromPatient,
                                       const Eigen::Vector3d& pointInPatient)
{
    return core::project(library::toCore(camera), library::toCore(cameraFromPatient) * pointInPatient);
}

}   // namespace angiopose

#include "core/geometry/c_arm.h"

#include "core/geometry/angle_units.h"
#include "core/messages/messages.h"

#include <cmath>
#include <utility>

namespace angiopose::core {
namespace {

bool isPositive(const SourcedValue<double>& sourced)
{
    return sourced.value && std::isfinite(*sourced.value) && *sourced.value > 0.0;
}

bool isKnown(const SourcedValue<double>& sourced)
{
    return sourced.value && std::isfinite(*sourced.value);
}

Error missing(const Message& what)
{
    return messages::valueMissing(what);
}

/// Returns the in-plane rotation of the image; a positive angle rotates the image clockwise on screen.
Eigen::Matrix3d rollRotation(double rollDeg, bool mirrored)
{
    // Screen right is −X (unmirrored) and screen down is +Y, so clockwise on screen is a negative rotation about +Z.
    const double sign = mirrored ? 1.0 : -1.0;
    return Eigen::AngleAxisd(sign * rollDeg * radiansPerDegree, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

}   // namespace

Eigen::Vector3d detectorDirection(double primaryAngleDeg, double secondaryAngleDeg)
{
    const double alpha = primaryAngleDeg * radiansPerDegree;
    const double beta = secondaryAngleDeg * radiansPerDegree;
    return {std::cos(beta) * std::sin(alpha), -std::cos(beta) * std::cos(alpha), std::sin(beta)};
}

Result<ProjectionCamera> cameraFromCArm(const CArm& cArm, int width, int height)
{
    if (!isPositive(cArm.sourceToDetectorMm)) {
        return missing(messages::sidName());
    }
    if (!isPositive(cArm.columnSpacingMm) || !isPositive(cArm.rowSpacingMm)) {
        return missing(messages::spacingName());
    }
    ProjectionCamera camera;
    camera.width = width;
    camera.height = height;
    const double sid = *cArm.sourceToDetectorMm.value;
    camera.fx = (cArm.mirrored.value.value_or(false) ? 1.0 : -1.0) * sid / *cArm.columnSpacingMm.value;
    camera.fy = sid / *cArm.rowSpacingMm.value;
    const Eigen::Vector2d center(0.5 * (width - 1), 0.5 * (height - 1));
    const Eigen::Vector2d principal = cArm.principalPointPx.value.value_or(center);
    camera.cx = principal.x();
    camera.cy = principal.y();
    if (const auto problem = findProblem(camera)) {
        return Error(*problem);
    }
    return camera;
}

Result<RigidTransform> cameraFromPatient(const CArm& cArm, const Eigen::Vector3d& isocenterInPatient)
{
    if (!isPositive(cArm.sourceToIsocenterMm)) {
        return missing(messages::sodName());
    }
    if (!isKnown(cArm.primaryAngleDeg) || !isKnown(cArm.secondaryAngleDeg)) {
        return Error(messages::anglesMissing());
    }
    if (!isocenterInPatient.allFinite()) {
        return Error(messages::isocenterNotFinite());
    }
    const double alpha = *cArm.primaryAngleDeg.value * radiansPerDegree;
    const double beta = *cArm.secondaryAngleDeg.value * radiansPerDegree;
    const Eigen::Vector3d direction = detectorDirection(*cArm.primaryAngleDeg.value, *cArm.secondaryAngleDeg.value);
    const Eigen::Vector3d imageRight(std::cos(alpha), std::sin(alpha), 0.0);
    const Eigen::Vector3d imageUp(-std::sin(beta) * std::sin(alpha), std::sin(beta) * std::cos(alpha), std::cos(beta));

    Eigen::Matrix3d rotation;
    rotation << -imageRight.transpose(), -imageUp.transpose(), direction.transpose();
    rotation = rollRotation(cArm.rollDeg.value.value_or(0.0), cArm.mirrored.value.value_or(false)) * rotation;
    const Eigen::Vector3d source = isocenterInPatient - *cArm.sourceToIsocenterMm.value * direction;
    return RigidTransform{rotation, -(rotation * source)};
}

void assumeIsocenter(CArm& cArm)
{
    if (!cArm.sourceToIsocenterMm.value && cArm.sourceToObjectMm.value) {
        cArm.sourceToIsocenterMm = {cArm.sourceToObjectMm.value, Origin::Assumed, cArm.sourceToObjectMm.basis};
    }
}

const SourcedValue<double>& vesselDepthOf(const CArm& cArm)
{
    return isPositive(cArm.sourceToObjectMm) ? cArm.sourceToObjectMm : cArm.sourceToIsocenterMm;
}

ImageAxes imageAxesOf(CArm cArm)
{
    for (SourcedValue<double>* angle : {&cArm.primaryAngleDeg, &cArm.secondaryAngleDeg}) {
        angle->value = isKnown(*angle) ? *angle->value : 0.0;
    }
    cArm.sourceToIsocenterMm.value = 1.0;
    const Eigen::Matrix3d rotation = cameraFromPatient(cArm, Eigen::Vector3d::Zero()).value().rotation;
    const double rightward = cArm.mirrored.value.value_or(false) ? 1.0 : -1.0;   // sign of fx
    return {rightward * rotation.row(0).transpose(), rotation.row(1).transpose()};
}

CArm rotateCArm(CArm cArm, const Eigen::Vector2d& incrementsDeg)
{
    for (const auto& [angle, increment] :
         {std::pair(&cArm.primaryAngleDeg, incrementsDeg.x()), std::pair(&cArm.secondaryAngleDeg, incrementsDeg.y())}) {
        if (angle->value && increment != 0.0) {
            *angle->value += increment;
            angle->basis += " plus this frame's increment";
        }
    }
    return cArm;
}

}   // namespace angiopose::core

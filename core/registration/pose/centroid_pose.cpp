#include "core/registration/pose/centroid_pose.h"

namespace angiopose::core {

CentroidPose aboutCentroid(const RigidTransform& cameraFromPatient, const Eigen::Vector3d& centroidInPatient)
{
    return {cameraFromPatient.rotation, cameraFromPatient * centroidInPatient};
}

RigidTransform cameraFromPatient(const CentroidPose& pose, const Eigen::Vector3d& centroidInPatient)
{
    return {pose.rotation, pose.centroidInCamera - pose.rotation * centroidInPatient};
}

CentroidPose retract(const CentroidPose& pose, const Vector6d& step)
{
    return {expSo3(step.head<3>()) * pose.rotation, pose.centroidInCamera + step.tail<3>()};
}

Vector6d stepBetween(const CentroidPose& from, const CentroidPose& to)
{
    Vector6d step;
    step << logSo3(to.rotation * from.rotation.transpose()), to.centroidInCamera - from.centroidInCamera;
    return step;
}

double stepLengthMm(const Vector6d& step, double spreadMm)
{
    return spreadMm * step.head<3>().norm() + step.tail<3>().norm();
}

}   // namespace angiopose::core

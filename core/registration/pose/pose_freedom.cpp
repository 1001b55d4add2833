#include "core/registration/pose/pose_freedom.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace angiopose::core {
namespace {

/// Axis of each coordinate: x tilts toward cranial, y toward LAO, z rolls (see PoseOffset).
constexpr std::array axisOfCoordinate{PoseAxis::CraCau, PoseAxis::LaoRao, PoseAxis::Roll,
                                      PoseAxis::Right,  PoseAxis::Up,     PoseAxis::AlongRay};

Eigen::Matrix3d rotationFromAngles(const Eigen::Vector3d& angles)
{
    return (Eigen::AngleAxisd(angles.z(), Eigen::Vector3d::UnitZ()) *
            Eigen::AngleAxisd(angles.x(), Eigen::Vector3d::UnitX()) *
            Eigen::AngleAxisd(angles.y(), Eigen::Vector3d::UnitY()))
        .toRotationMatrix();
}

/// Returns the inverse of rotationFromAngles for |θx| ≤ 90°: bottom row (−cos θx sin θy, sin θx, cos θx cos θy), middle
/// column Rz Rx e_y.
Eigen::Vector3d anglesOf(const Eigen::Matrix3d& turn)
{
    return {std::asin(std::clamp(turn(2, 1), -1.0, 1.0)), std::atan2(-turn(2, 0), turn(2, 2)),
            std::atan2(-turn(0, 1), turn(1, 1))};
}

/// Returns the rotation vector per rad of each angle, one per column, camera axes.
Eigen::Matrix3d rotationPerAngle(const Eigen::Vector3d& angles)
{
    const Eigen::Matrix3d roll = Eigen::AngleAxisd(angles.z(), Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const Eigen::Matrix3d tilt = Eigen::AngleAxisd(angles.x(), Eigen::Vector3d::UnitX()).toRotationMatrix();
    Eigen::Matrix3d axes;
    axes << roll.col(0), roll * tilt.col(1), Eigen::Vector3d::UnitZ();
    return axes;
}

bool isAnyShiftLocked(const PoseLocks& locks)
{
    return isLocked(locks, PoseAxis::Right) || isLocked(locks, PoseAxis::Up) || isLocked(locks, PoseAxis::AlongRay);
}

}   // namespace

PoseFreedom::PoseFreedom(const PoseLocks& locks, const Frame& frame, const CentroidPose& start)
    : locks_(locks), frame_(frame)
{
    if (!isAnyShiftLocked(locks)) {
        frame_.pivotFromCentroid.setZero();   // the solvers converge best with rotation about the centroid
    }
    start_ = coordinates(start);
}

bool PoseFreedom::isLocked(Eigen::Index coordinate) const
{
    return isLocked(axisOfCoordinate[static_cast<std::size_t>(coordinate)]);
}

PoseFreedom PoseFreedom::withLockedAxes(std::initializer_list<PoseAxis> axes, const CentroidPose& pose) const
{
    PoseLocks locks = locks_;
    for (const PoseAxis axis : axes) {
        locks[static_cast<std::size_t>(axis)] = true;
    }
    return {locks, isFull() ? Frame{pose.rotation, {0.0, 0.0, 0.0}} : frame_, pose};
}

PoseFreedom PoseFreedom::fromStart(const Eigen::Matrix3d& startRotation) const
{
    PoseFreedom motions = *this;
    motions.frame_.reference = frame_.reference * startRotation.transpose();
    motions.frame_.pivotFromCentroid = startRotation * frame_.pivotFromCentroid;
    return motions;
}

Vector6d PoseFreedom::coordinates(const CentroidPose& pose) const
{
    Vector6d coordinates;
    coordinates << anglesOf(pose.rotation * frame_.reference.transpose()),
        pose.centroidInCamera + pose.rotation * frame_.pivotFromCentroid;
    return coordinates;
}

CentroidPose PoseFreedom::poseAt(const Vector6d& coordinates) const
{
    const Eigen::Matrix3d rotation = rotationFromAngles(coordinates.head<3>()) * frame_.reference;
    return {rotation, coordinates.tail<3>() - rotation * frame_.pivotFromCentroid};
}

Matrix6d PoseFreedom::stepsPerCoordinate(const CentroidPose& pose) const
{
    const Eigen::Matrix3d turns = rotationPerAngle(anglesOf(pose.rotation * frame_.reference.transpose()));
    Matrix6d steps = Matrix6d::Identity();
    steps.topLeftCorner<3, 3>() = turns;
    steps.bottomLeftCorner<3, 3>() = skew(pose.rotation * frame_.pivotFromCentroid) * turns;
    return steps;
}

StepBasis PoseFreedom::freeSteps(const CentroidPose& pose) const
{
    if (isFull()) {
        return StepBasis::Identity(6, 6);   // because the angles may become dependent far from the reference
    }
    const Matrix6d all = stepsPerCoordinate(pose);
    StepBasis free(6, std::count(locks_.begin(), locks_.end(), false));
    Eigen::Index column = 0;
    for (Eigen::Index k = 0; k < 6; ++k) {
        if (!isLocked(k)) {
            free.col(column++) = all.col(k);
        }
    }
    return free;
}

CentroidPose PoseFreedom::restoreLockedAxes(const CentroidPose& pose) const
{
    if (isFull()) {
        return pose;
    }
    Vector6d kept = coordinates(pose);
    for (Eigen::Index k = 0; k < 6; ++k) {
        kept[k] = isLocked(k) ? start_[k] : kept[k];
    }
    return poseAt(kept);
}

Vector6d PoseFreedom::dampedStep(const NormalEquations& equations, double damping, const CentroidPose& pose) const
{
    return isFull() ? core::dampedStep(equations, damping) : core::dampedStep(equations, damping, freeSteps(pose));
}

CentroidPose PoseFreedom::retract(const CentroidPose& pose, const Vector6d& step) const
{
    return restoreLockedAxes(core::retract(pose, step));
}

}   // namespace angiopose::core

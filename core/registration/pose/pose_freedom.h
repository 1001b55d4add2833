#pragma once

#include "core/geometry/pose_axis.h"
#include "core/registration/pose/centroid_pose.h"

#include <initializer_list>

namespace angiopose::core {

/// Degrees of freedom that a registration may change; locked ones keep their initial values as defined by PoseOffset.
/// The six coordinates, in the order of Vector6d, are the angles θ in rad of rotation = Rz(θz) Rx(θx) Ry(θy) ·
/// reference, and the position of a pivot in camera axes in mm.
class PoseFreedom {
public:
    /// Reference of the coordinates; relevant only with locks.
    struct Frame {
        Eigen::Matrix3d reference = Eigen::Matrix3d::Identity();   ///< rotation at θ = 0
        Eigen::Vector3d pivotFromCentroid = Eigen::Vector3d::Zero();   ///< mm, axes of the posed frame
    };

    /// Leaves all six degrees of freedom free.
    PoseFreedom() = default;

    PoseFreedom(const PoseLocks& locks, const Frame& frame, const CentroidPose& start);

    bool isFull() const { return !isAnyLocked(locks_); }
    bool isLocked(PoseAxis axis) const { return core::isLocked(locks_, axis); }
    bool isLocked(Eigen::Index coordinate) const;

    /// Returns a copy in which these axes are also locked, at their values in `pose`.
    PoseFreedom withLockedAxes(std::initializer_list<PoseAxis> axes, const CentroidPose& pose) const;

    /// Returns the same freedom for motions cameraFromStart of a tree in the frame of the initial camera.
    PoseFreedom fromStart(const Eigen::Matrix3d& startRotation) const;

    Vector6d coordinates(const CentroidPose& pose) const;
    CentroidPose poseAt(const Vector6d& coordinates) const;

    /// Returns d step / d coordinate, one coordinate per column, with steps as in `retract`.
    Matrix6d stepsPerCoordinate(const CentroidPose& pose) const;

    /// Returns the columns of stepsPerCoordinate for the free coordinates.
    StepBasis freeSteps(const CentroidPose& pose) const;

    /// Returns the pose with the locked coordinates restored.
    CentroidPose restoreLockedAxes(const CentroidPose& pose) const;

    /// Returns the damped step by core::dampedStep that changes no locked coordinate, to first order.
    Vector6d dampedStep(const NormalEquations& equations, double damping, const CentroidPose& pose) const;

    /// Returns the pose after a step; locked coordinates keep their exact values.
    CentroidPose retract(const CentroidPose& pose, const Vector6d& step) const;

private:
    PoseLocks locks_{};
    Frame frame_;
    Vector6d start_ = Vector6d::Zero();   ///< values of the locked coordinates
};

}   // namespace angiopose::core

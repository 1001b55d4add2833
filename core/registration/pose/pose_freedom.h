#pragma once

#include "core/geometry/pose_axis.h"
#include "core/registration/pose/centroid_pose.h"

#include <initializer_list>

namespace angiopose::core {

/// Which degrees of freedom a registration may use; the locked ones keep the value that they have at the start, in the
/// terms of PoseOffset. Its six coordinates, in the order of Vector6d: the angles θ of
/// rotation = Rz(θz) Rx(θx) Ry(θy) · reference in rad, and the place of a pivot in the camera in mm.
class PoseFreedom {
public:
    /// What the coordinates are counted from. Only locks make it matter.
    struct Frame {
        Eigen::Matrix3d reference = Eigen::Matrix3d::Identity();   ///< rotation at θ = 0
        Eigen::Vector3d pivotFromCentroid = Eigen::Vector3d::Zero();   ///< mm, axes of the posed frame
    };

    /// All six are free.
    PoseFreedom() = default;

    PoseFreedom(const PoseLocks& locks, const Frame& frame, const CentroidPose& start);

    bool isFull() const { return !isAnyLocked(locks_); }
    bool isLocked(PoseAxis axis) const { return core::isLocked(locks_, axis); }
    bool isLocked(Eigen::Index coordinate) const;

    /// The same and these locked too, at the values of `pose`.
    PoseFreedom alsoLocking(std::initializer_list<PoseAxis> axes, const CentroidPose& pose) const;

    /// The same for motions cameraFromStart of a tree that stands in the start camera's frame.
    PoseFreedom fromStart(const Eigen::Matrix3d& startRotation) const;

    Vector6d coordinates(const CentroidPose& pose) const;
    CentroidPose poseAt(const Vector6d& coordinates) const;

    /// d step / d coordinate, one column each; steps as in `moved`.
    Matrix6d stepsPerCoordinate(const CentroidPose& pose) const;

    /// Its columns that are free.
    StepBasis freeSteps(const CentroidPose& pose) const;

    /// The pose with the locked coordinates put back.
    CentroidPose held(const CentroidPose& pose) const;

    /// The step by core::dampedStep that changes no locked coordinate, to first order.
    Vector6d dampedStep(const NormalEquations& equations, double damping, const CentroidPose& pose) const;

    /// The pose after a step; locked coordinates keep their value exactly.
    CentroidPose moved(const CentroidPose& pose, const Vector6d& step) const;

private:
    PoseLocks locks_{};
    Frame frame_;
    Vector6d start_ = Vector6d::Zero();   ///< coordinates that locked ones keep
};

}   // namespace angiopose::core
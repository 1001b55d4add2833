#pragma once

#include "core/registration/alignment/alignment.h"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace angiopose::core {

/// Pose of one tree in several views: the pose in the first view and small corrections of the geometry to the others.
struct JointPose {
    CentroidPose first;
    std::vector<Vector6d>
        corrections;   ///< one per view (rad, mm about the centroid, axes of that view); the first is zero
};

/// Camera of a view and its position relative to the first view, before the correction.
struct PlacedCamera {
    RigidTransform cameraFromFirst;
    ProjectionCamera camera;
};

/// Pose in view k.
CentroidPose poseInView(const JointPose& joint, std::span<const PlacedCamera> geometry, std::size_t view);

/// Combines the normal equations of all views. The parameters are the step of the first pose, followed by the
/// corrections of views 1, 2, …, 6 each. The correction of a view is applied after the geometry: a step of the first
/// pose reaches the view rotated by cameraFromFirst and the correction.
StackedEquations stacked(std::span<const NormalEquations> perView, const JointPose& joint,
                         std::span<const PlacedCamera> geometry);

/// Overload that includes the camera errors, three per view after all pose parameters.
StackedEquations stacked(std::span<const CameraEquations> perView, const JointPose& joint,
                         std::span<const PlacedCamera> geometry);

/// Joint pose after a step of all parameters.
JointPose moved(const JointPose& joint, const Eigen::VectorXd& step);

}   // namespace angiopose::core
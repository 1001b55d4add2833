#pragma once

#include "core/registration/alignment/alignment.h"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace angiopose::core {

/// One tree in several views: the pose in the first view, and small corrections of the geometry to the others.
struct JointPose {
    CentroidPose first;
    std::vector<Vector6d> corrections;   ///< one per view (rad, mm about the centroid, that view's axes); first zero
};

/// The camera of a view, and where it stands to that of the first view, without the correction.
struct PlacedCamera {
    RigidTransform cameraFromFirst;
    ProjectionCamera camera;
};

/// Pose in view k.
CentroidPose poseInView(const JointPose& joint, std::span<const PlacedCamera> geometry, std::size_t view);

/// What every view tells about its own pose, put together: parameters are the step of the first pose, then the
/// corrections of views 1, 2, …, 6 each. The correction of a view acts after the geometry, so a step of the first pose
/// reaches the view turned by cameraFromFirst and the correction.
StackedEquations stacked(std::span<const NormalEquations> perView, const JointPose& joint,
                         std::span<const PlacedCamera> geometry);

/// The same with the errors of the cameras, three for each view after all parameters of the poses.
StackedEquations stacked(std::span<const CameraEquations> perView, const JointPose& joint,
                         std::span<const PlacedCamera> geometry);

/// The joint pose after a step of all parameters.
JointPose moved(const JointPose& joint, const Eigen::VectorXd& step);

}   // namespace angiopose::core
#pragma once

#include "core/registration/alignment/alignment.h"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace angiopose::core {

/// Pose of one tree in several views: the pose in the first view and small corrections of the relative geometry.
struct JointPose {
    CentroidPose first;
    std::vector<Vector6d>
        corrections;   ///< one per view (rad, mm about the centroid, axes of that view); the first is zero
};

/// Camera of a view and its position relative to the first view, without the correction.
struct RelativeCamera {
    RigidTransform cameraFromFirst;
    ProjectionCamera camera;
};

/// Returns the pose of the tree in view `view`.
CentroidPose poseInView(const JointPose& joint, std::span<const RelativeCamera> geometry, std::size_t view);

/// Combines the normal equations of all views. The parameters are the step of the first view's pose, followed by six
/// correction parameters for each further view. Corrections are applied after cameraFromFirst; a step of the first pose
/// is therefore rotated by cameraFromFirst and the correction.
StackedEquations stackEquations(std::span<const NormalEquations> perView, const JointPose& joint,
                                std::span<const RelativeCamera> geometry);

/// Overload that appends three camera errors per view to the pose parameters.
StackedEquations stackEquations(std::span<const CameraEquations> perView, const JointPose& joint,
                                std::span<const RelativeCamera> geometry);

/// Returns the joint pose after a step in all parameters.
JointPose retract(const JointPose& joint, const Eigen::VectorXd& step);

}   // namespace angiopose::core

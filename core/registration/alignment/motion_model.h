#pragma once

#include "core/registration/pose/initial_pose_prior.h"

#include <deque>
#include <optional>

namespace angiopose::core {

/// Predicts the pose in the next frame (ALGORITHMS §6.11). The recent steps define the direction of breathing; the
/// predicted pose keeps the last speed along this direction and stays in place perpendicular to it.
class MotionModel {
public:
    /// Standard deviations of the frame-to-frame motion around the prediction.
    struct Noise {
        double rotationDeg = 0.2;
        double shiftMm = 1.0;
    };

    MotionModel(const CentroidPose& pose, double spreadMm, const Noise& noise);

    /// Predicts the next pose and its uncertainty, which grows with every frame without a pose.
    InitialPosePrior predict() const;

    /// Adds the pose of the next frame, or nullopt if no pose was determined.
    void advance(const std::optional<CentroidPose>& pose);

    /// Resets the pose after a new search; the jump is not used as a motion step.
    void resetTo(const CentroidPose& pose);

private:
    Vector6d breathingComponent(const Vector6d& step) const;

    CentroidPose pose_;
    Vector6d mmPerParameter_;   ///< factors that convert pose parameters (rad, mm) to mm
    Noise noise_;
    std::deque<Vector6d> steps_;   ///< frame-to-frame steps in mm, newest last
    bool isMoving_ = false;   ///< whether the last frame added a step to steps_
    int missedFrames_ = 0;
};

}   // namespace angiopose::core

#pragma once

#include "core/registration/pose/start_prior.h"

#include <deque>
#include <optional>

namespace angiopose::core {

/// Predicts the pose in the next frame: the recent steps define the direction of breathing, along which the tree
/// continues at its last speed (ALGORITHMS §6.11). Across that direction it is expected to stay in place.
class MotionModel {
public:
    /// Standard deviations of the frame-to-frame motion beyond the prediction.
    struct Noise {
        double rotationDeg = 0.2;
        double shiftMm = 1.0;
    };

    MotionModel(const CentroidPose& pose, double spreadMm, const Noise& noise);

    /// Predicts the next pose and its uncertainty, which grows with every unobserved frame.
    StartPrior predict() const;

    /// Adds the pose of the next frame; nullopt if it could not be determined.
    void advance(const std::optional<CentroidPose>& pose);

    /// Resets to a pose found by a new search, which is no motion to learn from.
    void jumpTo(const CentroidPose& pose);

private:
    Vector6d alongBreathing(const Vector6d& step) const;

    CentroidPose pose_;
    Vector6d inMm_;   ///< scales (rad, mm) parameters to mm
    Noise noise_;
    std::deque<Vector6d> steps_;   ///< frame-to-frame steps in mm, newest last
    bool isMoving_ = false;   ///< whether the last frame added a step
    int framesMissed_ = 0;
};

}   // namespace angiopose::core
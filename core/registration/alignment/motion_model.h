#pragma once

#include "core/registration/pose/start_prior.h"

#include <deque>
#include <optional>

namespace angiopose::core {

/// Where the next frame's pose is expected: the last steps tell the direction of the breathing, and the tree goes on
/// along it as fast as before (ALGORITHMS §6.11). Across that direction it is expected to stay.
class MotionModel {
public:
    /// Standard deviations of what a frame brings beyond the prediction.
    struct Noise {
        double rotationDeg = 0.2;
        double shiftMm = 1.0;
    };

    MotionModel(const CentroidPose& pose, double spreadMm, const Noise& noise);

    /// The next pose and how far it may be off; wider for every frame that was not observed.
    StartPrior predict() const;

    /// The pose of the next frame; nothing when it could not be told.
    void advance(const std::optional<CentroidPose>& pose);

    /// The tree was found again somewhere else: no motion to learn from.
    void jumpTo(const CentroidPose& pose);

private:
    Vector6d alongBreathing(const Vector6d& step) const;

    CentroidPose pose_;
    Vector6d inMm_;   ///< of (rad, mm) parameters
    Noise noise_;
    std::deque<Vector6d> steps_;   ///< between frames, newest last, in mm
    bool isMoving_ = false;   ///< the last frame added a step
    int framesMissed_ = 0;
};

}   // namespace angiopose::core
#pragma once

#include "core/registration/alignment/alignment.h"
#include "core/registration/alignment/motion_model.h"
#include "core/registration/alignment/pose_search.h"
#include "core/registration/matching/target_lines.h"
#include "core/registration/tracked_frame.h"

#include <deque>

namespace angiopose::core {

/// Tracks the vessels through one cine run (ALGORITHMS §6.11). For each frame, the pose predicted from the previous
/// motion is both starting point and prior; a search runs only if the fit is clearly worse than in the previous frames.
class FrameTracker {
public:
    /// `first` is a validated problem whose initial pose is the registered pose of the frame before the first tracked.
    FrameTracker(RegistrationProblem first, const RegistrationOptions& options, const MotionModel::Noise& noise = {});

    /// Tracks the next frame. If the target is empty or not finite, fails and leaves the tracker unchanged. Calls
    /// `observe` during a search; if it returns Stop, the search of this frame remains incomplete.
    Result<TrackedFrame> next(const Centerline2d& target, const SearchObserver& observe = {});

    /// Replaces the vessel shape; `deformed` is the problem with the same branches in their current shape.
    void updateTree(RegistrationProblem deformed);

private:
    bool isGoodFit(double score) const;
    double medianScore() const;
    CentroidPose searchAround(const TargetLines& lines, const CentroidPose& prediction, const CentroidPose& refined,
                              const SearchObserver& observe) const;
    void updateMotion(const TrackedFrame& frame, const CentroidPose& pose);

    RegistrationProblem problem_;
    RegistrationOptions options_;
    MotionModel motion_;
    std::vector<AlignmentPoint> points_;
    std::deque<double> scores_;   ///< scores of the successfully tracked frames, newest last
};

}   // namespace angiopose::core

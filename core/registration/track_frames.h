#pragma once

#include "core/registration/alignment/alignment.h"
#include "core/registration/alignment/motion_model.h"
#include "core/registration/alignment/pose_search.h"
#include "core/registration/matching/target_lines.h"
#include "core/registration/tracked_frame.h"

#include <deque>

namespace angiopose::core {

/// Tracks the vessels from frame to frame of one run (ALGORITHMS §6.11). Every frame starts from the pose predicted
/// from the previous motion, with the prediction as prior, and needs no search as long as it explains the frame about
/// as well as its predecessors.
class FrameTracker {
public:
    /// `first` is a validated problem whose initial pose is the registered pose of the frame before the first one to
    /// track.
    FrameTracker(RegistrationProblem first, const RegistrationOptions& options, const MotionModel::Noise& noise = {});

    /// Fails if the target is empty or not finite, leaving the tracker unchanged. `observe` is called during a search;
    /// if it stops the search, the frame has been searched only partly.
    Result<TrackedFrame> next(const Centerline2d& target, const SearchObserver& observe = {});

    /// Replaces the shape of the vessels: `bent` is the problem with the same branches in their current shape.
    void followAsDeformed(RegistrationProblem deformed);

private:
    bool isFit(double score) const;
    double medianScore() const;
    CentroidPose searchAround(const TargetLines& lines, const CentroidPose& prediction, const CentroidPose& refined,
                              const SearchObserver& observe) const;
    void learnFrom(const TrackedFrame& frame, const CentroidPose& pose);

    RegistrationProblem problem_;
    RegistrationOptions options_;
    MotionModel motion_;
    std::vector<AlignmentPoint> points_;
    std::deque<double> scores_;   ///< scores of fitting frames, newest last
};

}   // namespace angiopose::core
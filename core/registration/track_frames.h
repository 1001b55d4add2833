#pragma once

#include "core/registration/alignment/alignment.h"
#include "core/registration/alignment/motion_model.h"
#include "core/registration/alignment/pose_search.h"
#include "core/registration/matching/target_lines.h"
#include "core/registration/tracked_frame.h"

#include <deque>

namespace angiopose::core {

/// Follows the vessels from frame to frame of one run (ALGORITHMS §6.11). Every frame starts from the pose that the
/// motion so far predicts, with the prediction as prior, and needs no search while it explains the frame about as well
/// as its predecessors.
class FrameTracker {
public:
    /// `first`: a checked problem whose start is the registered pose of the frame before the first one tracked.
    FrameTracker(RegistrationProblem first, const RegistrationOptions& options, const MotionModel::Noise& noise = {});

    /// Fails when the target is empty or not finite; the tracker then stays as it was. `observe` hears of a search; a
    /// frame whose search it stopped has been looked at in part only.
    Result<TrackedFrame> next(const Centerline2d& target, const SearchObserver& observe = {});

    /// The vessels have changed their shape: `bent` is the problem of the same branches as they are now.
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
    std::deque<double> scores_;   ///< of frames that fitted, newest last
};

}   // namespace angiopose::core
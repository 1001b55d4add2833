#pragma once

#include "core/case/case.h"
#include "core/measuring/check_point_error.h"

#include <functional>

namespace angiopose::core {

/// What one view tells of a check point.
struct CheckedView {
    std::size_t view = 0;   ///< place in Case::views
    int frame = 0;   ///< in which it was pointed at
    Result<ImageError> error;   ///< of the vessels as the rigid pose has them
    std::optional<double> bentMm;   ///< the same error with the vessels bent, where that is known
    std::optional<ClaimedError> claimed;   ///< by the result that found the pose
};

/// What is known of one check point: where it was seen, and how far the pose lies beside that.
struct CheckedPoint {
    VesselMark mark;
    std::vector<CheckedView> views;   ///< in which it was pointed at, in the order of the case
    Result<MeetingPoint> meeting;   ///< of the rays of views whose pose is of the frame it was seen in
    std::vector<std::size_t> meetingViews;
    std::optional<double> claimedSpaceMm;   ///< the least that a result of these views claims

    /// From where the rays meet; of nothing where they do not.
    double spaceMm() const { return (meeting.value().pointInPatient - mark.pointInPatient).norm(); }
};

/// Camera from patient of a view by its place.
using PoseOfView = std::function<RigidTransform(std::size_t view)>;

/// Every check point of a case, in its order; rings are none. `poseOf`: as shown.
std::vector<CheckedPoint> checkedPoints(const Case& theCase, const PoseOfView& poseOf);
std::vector<CheckedPoint> checkedPoints(const Case& theCase);   ///< at the case's own poses

/// Short, for a list: "1.2 mm off, 0.6 mm claimed" of the shown view, else in space; nothing where neither is known.
std::optional<Message> labelOf(const CheckedPoint& checked, std::size_t shownView);

/// Sentences on what one view tells, and on what all views together tell.
Messages sentencesOf(const CheckedView& checked);
Messages spaceSentences(const CheckedPoint& checked);

}   // namespace angiopose::core

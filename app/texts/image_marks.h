#pragma once

#include "app/texts/deformed_vessels.h"
#include "core/case/case.h"
#include "core/measuring/check_points.h"
#include "core/measuring/image_scale.h"
#include "core/support/message.h"
#include "ui/scenes/image_mark.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace angiopose::app {

/// A view of a case as it is shown, for what lies on it.
struct PlacedView {
    const core::Case& session;
    std::size_t view = 0;
    int frame = 0;
    VesselShape shape = VesselShape::Deformed;   ///< places go along with bent vessels
    core::PoseOfView poseOf = {};   ///< as shown; not set: the case's own
    std::set<int> chosenMarks = {};   ///< places among the marks of the vessels
    std::set<int> chosenAnnotations = {};
};

/// Check points and rings of the vessels where the pose and the shape of the vessels put them, with how far they are
/// off and the places where they are seen, then arrows and words of the frame. `toText` says a message.
std::vector<ui::ImageMark> placedMarks(const PlacedView& placed,
                                       const std::function<std::string(const core::Message&)>& toText);

/// The marks as the vessels that are drawn at a pose have them.
std::vector<core::VesselMark> drawnMarks(const core::View& view, const core::Vessels& vessels,
                                         const core::RigidTransform& pose, VesselShape shape);

/// What is drawn on a frame of a view: its measurements with their values. `toText` says a message.
std::vector<ui::ImageMark> marksOf(const core::MeasuredView& seen, int frame,
                                   const std::function<std::string(const core::Message&)>& toText);

}   // namespace angiopose::app

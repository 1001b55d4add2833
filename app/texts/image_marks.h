#pragma once

#include "app/texts/deformed_vessels.h"
#include "core/case/case.h"
#include "core/measuring/image_scale.h"
#include "core/measuring/target_points.h"
#include "core/support/message.h"
#include "ui/scenes/image_mark.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace angiopose::app {

/// View of a case as drawn, on which marks are placed.
struct MarkedView {
    const core::Case& session;
    std::size_t view = 0;
    int frame = 0;
    VesselShape shape = VesselShape::Deformed;   ///< if `Deformed`, marks follow the deformed vessels
    core::PoseOfView poseOf = {};   ///< poses as drawn; if not set, those of the case
    std::set<int> selectedMarks = {};   ///< IDs of the selected marks on the vessels
    std::set<int> selectedAnnotations = {};
};

/// Returns the target points and rings, projected with the pose and shape of the vessels, with their errors and
/// observed positions, followed by the arrows and text annotations of the frame. `toText` converts a message to text.
std::vector<ui::ImageMark> placedMarks(const MarkedView& placed,
                                       const std::function<std::string(const core::Message&)>& toText);

/// Returns the vessel marks at their positions on the vessels as drawn at a pose.
std::vector<core::VesselMark> marksOnDrawnVessels(const core::View& view, const core::Vessels& vessels,
                                                  const core::RigidTransform& pose, VesselShape shape);

/// Returns the measurements of a frame of a view with their values. `toText` converts a message to text.
std::vector<ui::ImageMark> marksOf(const core::MeasurementContext& seen, int frame,
                                   const std::function<std::string(const core::Message&)>& toText);

}   // namespace angiopose::app

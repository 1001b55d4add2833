#pragma once

#include "core/case/view.h"
#include "core/viewing/angle_map.h"

namespace angiopose::core {

/// The angles of a view's gantry when its frame was taken; nothing where they are not known.
std::optional<GantryAngles> gantryAnglesOf(const View& view);

/// The vessels at their pose in the view, with the gantry turned to other angles about its isocentre. Fails where the
/// view lacks angles or the distance from source to isocentre.
Result<PoseAtAngles> turningGantry(const View& view);

}   // namespace angiopose::core

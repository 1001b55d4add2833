#pragma once

#include "core/case/vessels.h"
#include "core/case/view.h"
#include "core/registration/register_views.h"

namespace angiopose::core {

/// Transform from the camera of one view to that of another.
struct RelativeViewPose {
    RigidTransform viewFromFirst;
    RelativePoseStd spread;
    Messages notes{};   ///< messages for the user about unknown parts of the geometry
};

/// Computes the transform from the distances and angles of both gantries about the isocenter. The isocenter moves in
/// the patient with the table position in the headers, but stays fixed between the planes of a biplane acquisition and
/// between frames of one run. If the table position or the isocenter is unknown, only the rotation comes from the
/// gantries, and the position of the vessels comes from each view's initial pose. If a view lacks angles, the transform
/// connects the initial poses (ALGORITHMS §5.5). Fails if a view has neither.
Result<RelativeViewPose> relativeViewPose(const View& first, const View& view, const Vessels& vessels);

}   // namespace angiopose::core

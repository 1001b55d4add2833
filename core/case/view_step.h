#pragma once

#include "core/case/vessels.h"
#include "core/case/view.h"
#include "core/registration/register_views.h"

namespace angiopose::core {

/// What leads from the camera of one view to that of another.
struct ViewStep {
    RigidTransform viewFromFirst;
    StepSpread spread;
    Messages notes{};   ///< what of the geometry is not known, in words
};

/// Distances and angles of both gantries about the isocenter, which the table carries through the patient: by its tags,
/// not at all between the planes of a bi-plane acquisition and the frames of one run. Where nothing tells how the table
/// stood, or where the isocenter is, the turn alone is taken from the gantries, and the vessels lie as far off as each
/// view starts by itself. Where a view lacks angles, what leads from start pose to start pose (ALGORITHMS §5.5). Fails
/// where a view has neither.
Result<ViewStep> stepToView(const View& first, const View& view, const Vessels& vessels);

}   // namespace angiopose::core

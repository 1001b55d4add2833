#pragma once

#include "core/registration_case.h"

#include <span>
#include <vector>

namespace angiopose::core {

/// From the camera of one view to that of another: distances and angles of both gantries about one isocentre, whatever
/// coordinates the vessels have; where a view lacks them, what leads from start pose to start pose (ALGORITHMS §5.5).
/// Fails where a view has neither.
Result<RigidTransform> viewFromView(const RegistrationCase& first, const RegistrationCase& view);

/// What registerViews needs of several cases that show the same vessels: tree and branches of the first, and for each
/// view its camera, its target and a start pose. The first starts where its case is; the others where the geometry
/// between the views then puts them: distances and angles of both gantries about one isocentre (ALGORITHMS §5.5),
/// whatever coordinates the vessels have; where a view lacks them, the start poses of the two.
/// Fails naming the view (counted from 1) and what it lacks.
Result<std::vector<RegistrationInput>> jointInputsOf(std::span<const RegistrationCase> views,
                                                     std::span<const Centerline2d> targets);

}   // namespace angiopose::core
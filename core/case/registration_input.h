#pragma once

#include "core/case/case.h"
#include "core/registration/register_views.h"

#include <span>
#include <vector>

namespace angiopose::core {

/// What a worker needs to register a view; fails naming what is still lacking. The registration starts from the current
/// pose.
Result<RegistrationInput> registrationInputOf(const View& view, const Vessels& vessels, Centerline2d target);

/// Likewise of the shown view.
Result<RegistrationInput> registrationInputOf(const Case& theCase, Centerline2d target);

/// What registerViews needs of several views: for each its camera, its target and a start pose. The first starts where
/// it is; the others where the geometry between the views then puts them, see viewFromView. Fails naming the view, by
/// what `multiView` calls it, and what it lacks.
Result<std::vector<RegistrationInput>> jointInputsOf(std::span<const View> views, const Vessels& vessels,
                                                     std::span<const Centerline2d> targets,
                                                     const MultiViewOptions& multiView = {});

}   // namespace angiopose::core

#pragma once

#include "core/case/case.h"
#include "core/registration/register_views.h"

#include <span>
#include <vector>

namespace angiopose::core {

/// The options for a run that starts with this view: where the vessels start in the object plane that the device
/// assumed, and nobody said how far off that is, their depth there is as unsure as such planes are.
RegistrationOptions optionsFor(const View& view, const Vessels& vessels, RegistrationOptions options);

/// What a worker needs to register a view; fails naming what is still lacking. The registration starts from the current
/// pose.
Result<RegistrationInput> registrationInputOf(const View& view, const Vessels& vessels, Centerline2d target);

/// Likewise of the shown view.
Result<RegistrationInput> registrationInputOf(const Case& session, Centerline2d target);

/// What registerViews needs of several views.
struct JointInputs {
    std::vector<RegistrationInput> views;   ///< each with its camera, its target and a start pose
    MultiViewOptions multiView;   ///< as given, with how well the steps between them are known
    Messages notes{};   ///< what is not known of these, naming the view
};

/// The first view starts where it is; the others where the geometry between the views then puts them, see stepToView.
/// Fails naming the view, by what `multiView` calls it, and what it lacks.
Result<JointInputs> jointInputsOf(std::span<const View> views, const Vessels& vessels,
                                  std::span<const Centerline2d> targets, MultiViewOptions multiView = {});

}   // namespace angiopose::core

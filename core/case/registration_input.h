#pragma once

#include "core/case/case.h"
#include "core/registration/register_views.h"

#include <span>
#include <vector>

namespace angiopose::core {

/// Returns the options adapted to a registration that starts from this view. If the vessels start in the object plane
/// assumed by the imaging system and the depth prior has its default value, the depth prior is set to the uncertainty
/// of such planes.
RegistrationOptions optionsFor(const View& view, const Vessels& vessels, RegistrationOptions options);

/// Returns everything a worker needs to register a view from its current pose. The error names the missing input.
Result<RegistrationInput> makeRegistrationInput(const View& view, const Vessels& vessels, Centerline2d target);

/// Overload for the shown view.
Result<RegistrationInput> makeRegistrationInput(const Case& session, Centerline2d target);

/// Input of registerViews for several views.
struct JointInputs {
    std::vector<RegistrationInput> views;   ///< each with its camera, target and initial pose
    MultiViewOptions multiView;   ///< given options, plus the uncertainty of the transforms between the views
    Messages notes{};   ///< unknown parts of the geometry between the views; each note names its view
};

/// Returns the input for several views. The first view starts at its current pose, the others at the pose that follows
/// from the geometry between the views (see relativeViewPose). The error names the missing input and the view, by its
/// number in `multiView`.
Result<JointInputs> makeJointInputs(std::span<const View> views, const Vessels& vessels,
                                    std::span<const Centerline2d> targets, MultiViewOptions multiView = {});

}   // namespace angiopose::core

#pragma once

#include "core/registration_case.h"

namespace angiopose::core {

/// What belongs to one view of a case: image, target, geometry, poses, result, snapshots. No vessels, no options.
RegistrationCase viewOf(const RegistrationCase& registrationCase);

/// The case with another view's image, geometry and poses in place of its own. Its list of other views stays.
RegistrationCase withView(RegistrationCase registrationCase, const RegistrationCase& view);

/// The case that shows its other view `index`, and has its own among the others at that place.
RegistrationCase showingView(RegistrationCase registrationCase, std::size_t index);

/// The case of each view, the case's own first: with the case's vessels and options. Views whose image is not there
/// are left out.
std::vector<RegistrationCase> casesOfViews(const RegistrationCase& registrationCase);

/// The other views after the vessels were moved to `cameraFromPatient` in the shown one: the cameras keep their places
/// to each other, as they are now, and results of runs hold no longer. Views without an image stay as they are.
std::vector<OtherView> movedAlong(const RegistrationCase& registrationCase, const RigidTransform& cameraFromPatient);

/// The other views, each at its own start pose where it has one.
std::vector<OtherView> atStart(const RegistrationCase& registrationCase);

}   // namespace angiopose::core
#pragma once

#include "core/registration/register_views.h"
#include "core/registration_case.h"

#include <vector>

namespace angiopose::app {

/// A case after a run over all its views.
struct JointPoses {
    core::RegistrationCase own;   ///< the shown view with its pose, result and the snapshot the run leaves
    std::vector<core::OtherView> others;   ///< the same for the others; those without an image stay as they were
};

/// `joint` must be of core::casesOfViews(registrationCase).
JointPoses jointPosesOf(const core::RegistrationCase& registrationCase, const core::MultiViewResult& joint);

}   // namespace angiopose::app
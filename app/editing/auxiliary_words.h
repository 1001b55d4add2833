#pragma once

#include "app/editing/branch_advice.h"
#include "core/case/case.h"
#include "ui/dialogs/auxiliary_dialog.h"

#include <optional>
#include <string>

namespace angiopose::app {

/// The method that takes the auxiliary branches throughout.
extern const std::string alternatingMethod;

double medianRadiusMm(const core::VesselBranch& branch);   ///< 0: it knows no radii

/// What the dialog of the auxiliary branches shows of a case, in the language spoken: what the choice comes to, and,
/// where it is known, what the branches tell about the pose.
ui::AuxiliaryAdvice auxiliaryWords(const core::Case& current, const std::optional<BranchAdvice>& advice);

}   // namespace angiopose::app

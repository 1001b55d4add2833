#pragma once

#include "app/editing/branch_advice.h"
#include "core/case/case.h"
#include "ui/dialogs/auxiliary_dialog.h"

#include <optional>
#include <string>

namespace angiopose::app {

/// Id of the method that uses the auxiliary branches in every step.
extern const std::string alternatingMethod;

double medianRadiusMm(const core::VesselBranch& branch);   ///< median radius of the branch, mm; 0 if it has no radii

/// Builds the texts of the auxiliary-branch dialog in the current language: the effect of the selection and, if known,
/// how well the branches constrain the pose.
ui::AuxiliaryAdvice auxiliaryTexts(const core::Case& current, const std::optional<BranchAdvice>& advice);

}   // namespace angiopose::app

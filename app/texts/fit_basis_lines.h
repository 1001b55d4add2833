#pragma once

#include "core/workflow/pose_evaluation.h"

namespace angiopose::app {

/// Describes the part of the tree to which the distances of a fit refer, with the value for the whole tree, the
/// excluded branches and their medians, and the auxiliary branches. Empty if the distances cover the whole tree.
core::Messages fitBasisLines(const core::FitBasis& basis, const core::Vessels& vessels);

}   // namespace angiopose::app

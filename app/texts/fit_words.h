#pragma once

#include "core/workflow/pose_judgement.h"

namespace angiopose::app {

/// Describes the part of the tree to which the distances of a fit refer, with the value over the whole tree, the
/// excluded branches with their medians, and the auxiliary branches. Empty if the distances cover the whole tree.
core::Messages fitWords(const core::FitBasis& basis, const core::Vessels& vessels);

}   // namespace angiopose::app

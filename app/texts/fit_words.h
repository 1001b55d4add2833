#pragma once

#include "core/workflow/pose_judgement.h"

namespace angiopose::app {

/// What the distances of a fit are about where that is not all of the tree, with the value over all of it; the branches
/// left out, each with its median, and the auxiliary ones. Empty where the distances are over the whole tree.
core::Messages fitWords(const core::FitBasis& basis, const core::Vessels& vessels);

}   // namespace angiopose::app

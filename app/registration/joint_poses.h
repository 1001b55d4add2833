#pragma once

#include "core/case/case.h"
#include "core/registration/register_views.h"

#include <vector>

namespace angiopose::app {

/// The views of a case after a run over all of them: each with its pose, its result and the snapshot the run leaves;
/// those without an image stay as they were. `joint` must be of core::registeredViews(theCase).
std::vector<core::View> viewsAfter(const core::Case& theCase, const core::MultiViewResult& joint);

}   // namespace angiopose::app

#pragma once

#include "core/case/case.h"
#include "io/vessel/fiducial.h"

namespace angiopose::io {

/// Check points, centres of rings, and the places of the shown view's landmarks; the description says which.
std::vector<Fiducial> pointsOf(const core::Case& session);

}   // namespace angiopose::io

#pragma once

#include "core/case/case.h"
#include "io/vessel/fiducial.h"

namespace angiopose::io {

/// Target points, ring centers and the 3-D positions of the shown view's landmarks; the description gives the kind.
std::vector<Fiducial> caseFiducials(const core::Case& session);

}   // namespace angiopose::io

#pragma once

#include "core/case/case.h"
#include "io/vessel/fiducial.h"

namespace angiopose::io {

/// Returns the target points, ring centers and 3-D landmarks of the shown view; the description states the kind.
std::vector<Fiducial> caseFiducials(const core::Case& session);

}   // namespace angiopose::io

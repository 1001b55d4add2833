#pragma once

#include "core/case/case.h"

namespace angiopose::app {

/// Returns the case with the geometry `cArm`; a pose equal to the initial pose follows the new initial pose.
core::Case replaceGeometry(core::Case base, const core::CArm& cArm);

}   // namespace angiopose::app

#pragma once

#include "core/case/case.h"

namespace angiopose::app {

/// The case moved to `cArm`: a pose that still was the start pose follows the new one.
core::Case withGeometry(core::Case base, const core::CArm& cArm);

}   // namespace angiopose::app

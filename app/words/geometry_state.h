#pragma once

#include "core/case/case.h"
#include "ui/panels/geometry_values.h"

namespace angiopose::app {

/// What the geometry panel says about a case.
ui::GeometryState geometryState(const core::Case& current);

}   // namespace angiopose::app
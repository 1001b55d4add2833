#pragma once

#include "core/case/case.h"
#include "ui/panels/geometry_values.h"

namespace angiopose::app {

/// Returns the state of the geometry panel for a case.
ui::GeometryState geometryState(const core::Case& current);

}   // namespace angiopose::app

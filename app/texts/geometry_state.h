#pragma once

#include "core/registration_case.h"
#include "ui/panels/geometry_values.h"

namespace angiopose::app {

/// What the geometry panel says about a case.
ui::GeometryState geometryState(const core::RegistrationCase& current);

}   // namespace angiopose::app
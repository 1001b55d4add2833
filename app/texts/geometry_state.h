#pragma once

#include "core/registration_case.h"
#include "ui/panels/geometry_values.h"

namespace app {

/// What the geometry panel says about a case.
ui::GeometryState geometryState(const core::RegistrationCase& current);

}   // namespace app

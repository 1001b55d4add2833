#pragma once

#include "core/case/view.h"

#include <string>

namespace angiopose::io {

/// The values of the JSON under `geometry`, each with its origin, and `geometry.camera`; what makes no sense goes into
/// the problems. The schema has been checked.
void readGeometry(const std::string& json, core::ViewGeometry& geometry, core::Messages& problems);

}   // namespace angiopose::io
#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// Returns the members of `geometry`: the C-arm values, each with its origin, and a camera that overrides them.
StoredFields<core::ViewGeometry> geometryFields();

}   // namespace angiopose::io

#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// The members of `geometry`: the values of the C-arm, each with its origin, and a camera that overrides them.
StoredFields<core::ViewGeometry> geometryFields();

}   // namespace angiopose::io

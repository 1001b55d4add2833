#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// The row of check points and rings on the vessels.
StoredField<core::Vessels> marksField();

/// The rows of where check points are seen in a view, and of arrows and words on it.
StoredField<core::View> sightingsField();
StoredField<core::View> annotationsField();

}   // namespace angiopose::io

#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// Returns the field of the target points and ostium rings on the vessels.
StoredField<core::Vessels> marksField();

/// Returns the field of the target points marked in a view's image, and of the arrows and text annotations on it.
StoredField<core::View> observationsField();
StoredField<core::View> annotationsField();

}   // namespace angiopose::io

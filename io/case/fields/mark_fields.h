#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// Field of the target points and ostium rings on the vessels.
StoredField<core::Vessels> marksField();

/// Field of the target points marked in a view's image, and of the arrows and text annotations on that image.
StoredField<core::View> sightingsField();
StoredField<core::View> annotationsField();

}   // namespace angiopose::io

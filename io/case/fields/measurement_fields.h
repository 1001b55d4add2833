#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// Returns the field of the measurements in a view's image.
StoredField<core::View> measurementsField();

/// Returns the field of the measurements in slices of the scan.
StoredField<core::Vessels> sliceMeasurementsField();

}   // namespace angiopose::io

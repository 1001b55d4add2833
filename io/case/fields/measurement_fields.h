#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// Field of the measurements in a view's image.
StoredField<core::View> measurementsField();

/// Field of the measurements in slices of the scan.
StoredField<core::Vessels> sliceMeasurementsField();

}   // namespace angiopose::io

#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// The row of what was measured in the image of a view.
StoredField<core::View> measurementsField();

/// The row of what was measured in slices of the scan.
StoredField<core::Vessels> sliceMeasurementsField();

}   // namespace angiopose::io

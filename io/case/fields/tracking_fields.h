#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// Returns the field of the tracking result of a view's cine run: poses and deformation summaries. The deformed points
/// are stored in a file next to the case (io/case/tracked_deformations_file).
StoredField<core::View> trackingField();

}   // namespace angiopose::io

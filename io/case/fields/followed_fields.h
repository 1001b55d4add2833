#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// The tracking result of a view's cine run: poses and deformation summaries. The deformed points are stored in a file
/// beside the case (io/case/tracked_deformations_file).
StoredField<core::View> followedField();

}   // namespace angiopose::io

#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// Returns the members of `angiogram.subtraction`. A missing member takes its value from the image header once the
/// image is read.
StoredField<core::View> subtractionField();

}   // namespace angiopose::io

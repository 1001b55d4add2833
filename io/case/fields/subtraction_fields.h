#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// Members of `angiogram.subtraction`. A member that is absent takes its value from the image header once the image is
/// read.
StoredField<core::View> subtractionField();

}   // namespace angiopose::io

#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// The members of `angiogram.subtraction`. An absent member takes the value of the image's header; the notes leave it
/// open until the image is read.
StoredField<core::View> subtractionField();

}   // namespace angiopose::io

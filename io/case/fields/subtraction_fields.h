#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// What stands under `angiogram.subtraction`. What is absent stays as the image's header has it, so that the notes keep
/// it open until that is read.
StoredField<core::View> subtractionField();

}   // namespace angiopose::io

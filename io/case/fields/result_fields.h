#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// Returns the fields of a registration result in `result.json` and in a case (FORMATS §2.9, §3.1).
const StoredFields<core::RegistrationResult>& resultFields();

/// Returns the field of a view's result. A view whose pose in the file is no longer that of the result has none.
StoredField<core::View> resultField();

}   // namespace angiopose::io

#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// The fields of a registration result in `result.json` and in a case (FORMATS §2.9, §3.1).
const StoredFields<core::RegistrationResult>& resultFields();

/// The result of a view, only while the pose in the file is still the result's pose; a pose changed in the file has no
/// result.
StoredField<core::View> resultField();

}   // namespace angiopose::io

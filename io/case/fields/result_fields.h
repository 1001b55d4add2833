#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// The fields of a registration result in `result.json` and in a case (FORMATS §2.9, §3.1).
const StoredFields<core::RegistrationResult>& resultFields();

/// Result of a view. If the pose in the file was changed and is no longer the result's pose, the view has no result.
StoredField<core::View> resultField();

}   // namespace angiopose::io

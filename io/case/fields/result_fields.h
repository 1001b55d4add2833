#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// What a run found, as it stands in `result.json` and in a case (FORMATS §2.9, §3.1).
const StoredFields<core::RegistrationResult>& resultFields();

/// The result of a view, while the pose in the file is still its pose: one that was changed there has none.
StoredField<core::View> resultField();

}   // namespace angiopose::io

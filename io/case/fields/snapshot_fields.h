#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// Members of `snapshots`, which are numbered from 1.
StoredField<core::View> snapshotsField();

}   // namespace angiopose::io

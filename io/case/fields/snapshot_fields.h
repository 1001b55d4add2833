#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// The members of `snapshots`, numbered from 1.
StoredField<core::View> snapshotsField();

}   // namespace angiopose::io

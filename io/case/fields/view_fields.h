#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// Everything that a case file keeps of a view: one row each.
const StoredFields<core::View>& viewFields();

}   // namespace angiopose::io

#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// Returns all fields of a view in a case file, one row each.
const StoredFields<core::View>& viewFields();

/// Returns the members of `angiogram.trace`, the settings of frame tracing.
const StoredFields<core::TraceOptions>& traceOptionFields();

}   // namespace angiopose::io

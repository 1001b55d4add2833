#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// All fields of a view in a case file, one row each.
const StoredFields<core::View>& viewFields();

/// The members of `angiogram.trace`: settings of frame tracing.
const StoredFields<core::TraceOptions>& traceOptionFields();

}   // namespace angiopose::io

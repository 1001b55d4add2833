#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// Everything that a case file keeps of a view: one row each.
const StoredFields<core::View>& viewFields();

/// What stands under `angiogram.trace`: how a frame is traced.
const StoredFields<core::TraceOptions>& traceOptionFields();

}   // namespace angiopose::io

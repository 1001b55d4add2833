#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// Returns the members of `vessel`, one row each.
const StoredFields<core::Vessels>& vesselFields();

/// Returns the members of `vessel.tracing`, the settings of vessel tracing.
const StoredFields<core::VesselTracingOptions>& vesselTracingFields();

}   // namespace angiopose::io

#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// The members of `vessel`, one row each.
const StoredFields<core::Vessels>& vesselFields();

/// The members of `vessel.tracing`: settings of vessel tracing.
const StoredFields<core::VesselTracingOptions>& vesselTracingFields();

}   // namespace angiopose::io

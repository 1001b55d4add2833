#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// What stands under `vessel`: one row each.
const StoredFields<core::Vessels>& vesselFields();

/// What stands under `vessel.tracing`: how vessels are traced.
const StoredFields<core::VesselTracingOptions>& vesselTracingFields();

}   // namespace angiopose::io

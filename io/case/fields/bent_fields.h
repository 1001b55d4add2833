#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// What bending found for a result, as a case keeps it: with the motion of every point. How far the rigid pose's
/// covariance was widened by it stands in the result's own.
StoredField<core::RegistrationResult> bentField();

/// The same without what it says of single points, for bends whose points stand elsewhere.
StoredFields<core::DeformableResult> bentFieldsWithoutPoints();

/// The same as result.json says it (FORMATS §3.5): of each branch how far it moved, not its points.
Json bentSummary(const core::DeformableResult& bent);

}   // namespace angiopose::io

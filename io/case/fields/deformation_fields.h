#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// What bending found for a result, as a case keeps it: with the motion of every point. How far the rigid pose's
/// covariance was widened by it stands in the result's own.
StoredField<core::RegistrationResult> deformedField();

/// The same without what it says of single points, for bends whose points stand elsewhere.
StoredFields<core::DeformableResult> deformedFieldsWithoutPoints();

/// The same as result.json says it (FORMATS §3.5): of each branch how far it moved, not its points.
Json deformedSummary(const core::DeformableResult& deformed);

}   // namespace angiopose::io

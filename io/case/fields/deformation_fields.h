#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// Returns the field of the deformation stored with a result, including the displacement of every point. The increase
/// in the covariance of the rigid pose due to the deformation is stored in the result itself.
StoredField<core::RegistrationResult> deformationField();

/// Returns the fields of a deformation without its points, for points stored in another file.
StoredFields<core::DeformableResult> deformationFieldsWithoutPoints();

/// Returns a summary of a deformation for result.json (FORMATS §3.5): the displacement of each branch, without points.
Json deformationSummary(const core::DeformableResult& deformed);

}   // namespace angiopose::io

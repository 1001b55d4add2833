#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// Deformation stored with a result, including the displacement of every point. How much the deformation increased the
/// covariance of the rigid pose is stored in the result itself.
StoredField<core::RegistrationResult> deformationField();

/// Fields of a deformation without its points, for points that are stored in another file.
StoredFields<core::DeformableResult> deformationFieldsWithoutPoints();

/// Summary of a deformation for result.json (FORMATS §3.5): the displacement of each branch without its points.
Json deformationSummary(const core::DeformableResult& deformed);

}   // namespace angiopose::io

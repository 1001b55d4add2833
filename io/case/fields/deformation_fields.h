#pragma once

#include "io/case/fields/stored_field.h"

namespace angiopose::io {

/// The deformation stored with a result, including the displacement of every point. The result itself stores how much
/// the deformation widened the covariance of the rigid pose.
StoredField<core::RegistrationResult> deformedField();

/// The same without the points, for deformations whose points are stored in another file.
StoredFields<core::DeformableResult> deformedFieldsWithoutPoints();

/// Summary of a deformation for result.json (FORMATS §3.5): the displacement of each branch without its points.
Json deformedSummary(const core::DeformableResult& deformed);

}   // namespace angiopose::io

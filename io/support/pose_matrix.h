#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/support/result.h"

#include <string>
#include <vector>

namespace angiopose::io {

using MatrixRows = std::vector<std::vector<double>>;

/// Builds a pose from the rows of a 4×4 matrix. Replaces a rotation rounded in the file (by up to 1e-3) by the nearest
/// one; leaves exact ones unchanged to the last bit. Fails on other shapes, NaN, reflections and non-rigid matrices.
core::Result<core::RigidTransform> poseFromRows(const MatrixRows& rows);

MatrixRows rowsOf(const core::RigidTransform& pose);

}   // namespace angiopose::io

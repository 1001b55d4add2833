#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/support/result.h"

#include <string>
#include <vector>

namespace io {

/// A 4×4 matrix, row-major, as files write it.
using MatrixRows = std::vector<std::vector<double>>;

/// The rigid transform of a 4×4 matrix. Rounding in the file is repaired; a matrix farther than 1e-3 from a rotation,
/// a reflection, a scale or a value that is not finite is refused. `place` names file and key in the message.
core::Result<core::RigidTransform> rigidFromRows(const MatrixRows& rows, const std::string& place);

MatrixRows rowsOf(const core::RigidTransform& transform);

}   // namespace io

#pragma once

#include "core/vessel/surface_mesh.h"

#include <cstddef>

namespace angiopose::core {

inline constexpr double maxBodySizeMm = 2500.0;   ///< maximum distance between two points of a body

/// Removes points that cannot belong to the same body as the others (not finite, or farther than `maxBodySizeMm` from
/// the median of all points) and their triangles; returns the number of removed points. If this affects more than one
/// point in a hundred, the unit is probably wrong, and nothing is removed.
std::size_t removeStrayPoints(SurfaceMesh& mesh);

}   // namespace angiopose::core

#pragma once

#include "core/vessel/surface_mesh.h"

#include <cstddef>

namespace angiopose::core {

inline constexpr double largestReachMm = 2500.0;   ///< maximum distance between two points of a body

/// Removes points that cannot belong to the same body as the others (not finite, or farther than `largestReachMm` from
/// their center) and their triangles; returns their number. If they are more than one in a hundred, the unit is
/// probably wrong, and nothing is removed.
std::size_t dropStrayPoints(SurfaceMesh& mesh);

}   // namespace angiopose::core

#pragma once

#include "core/vessel/surface_mesh.h"

#include <cstddef>

namespace angiopose::core {

inline constexpr double largestReachMm = 2500.0;   ///< no two places of a body are farther apart

/// Takes out points that cannot be of one body with the others (no numbers, or farther than `largestReachMm` from their
/// middle) and the triangles at them; returns how many. Where these are more than one in a hundred, the unit is wrong
/// rather than a point astray: nothing is taken out then.
std::size_t dropStrayPoints(SurfaceMesh& mesh);

}   // namespace angiopose::core

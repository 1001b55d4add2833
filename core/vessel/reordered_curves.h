#pragma once

#include "core/vessel/centerline2d.h"

#include <optional>

namespace angiopose::core {

/// Curves after reordering.
struct ReorderedCurves {
    Centerline2d curves;
    std::size_t reorderedPoints = 0;   ///< number of points that were out of order
};

/// Reorders curves if necessary. Along an ordered curve, the nearest neighbor of a point is the previous or next point.
/// Curves for which this is false at too many points (skeleton pixels listed row by row, points in any order) are
/// rebuilt from their points (chainPoints) and lose their radii, as are single points if most curves are single points.
/// Returns nullopt if all curves are in order. Points must be finite.
std::optional<ReorderedCurves> reorderCurves(const Centerline2d& input);

}   // namespace angiopose::core

#pragma once

#include "core/vessel/centerline2d.h"

#include <optional>

namespace angiopose::core {

/// Curves after reordering.
struct OrderedCurves {
    Centerline2d curves;
    std::size_t reorderedPoints = 0;   ///< number of points that were unordered
};

/// Reorders curves if necessary: along an ordered curve, a point's nearest neighbor is the previous or next point. If
/// this fails for most points (skeleton pixels row by row, points in any order), or if most curves are single points,
/// the points are chained (chainPoints) and lose their radii. Returns nothing if all curves are in order. Points must
/// be finite.
std::optional<OrderedCurves> putInOrder(const Centerline2d& given);

}   // namespace angiopose::core

#pragma once

#include "core/vessel/centerline2d.h"

#include <optional>

namespace angiopose::core {

/// Curves put in order.
struct OrderedCurves {
    Centerline2d curves;
    std::size_t reorderedPoints = 0;   ///< of points that came in no order
};

/// What is given is recognised: along a curve a point's nearest neighbour comes just before or after it. Where it
/// mostly does not (pixels of a skeleton row by row, points in any order), or where points come one by one, they are
/// chained (chainPoints); their radii are lost. Nothing: all curves are in order. Points must be finite.
std::optional<OrderedCurves> putInOrder(const Centerline2d& given);

}   // namespace angiopose::core

#pragma once

#include "core/registration/wire/projected_knots.h"
#include "core/registration/wire/step_cost.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Knot of a path matched to a point of the curve.
struct WirePair {
    std::size_t knot = 0;   ///< index of the knot in the path
    std::size_t point = 0;   ///< index of the point in the curve
    WireMove move;   ///< move that ends here; empty for the first pair
    double lengthMm = 0.0;   ///< length of wire or centerline that the pair represents
};

/// Monotonic alignment of a wire curve with a path through the tree.
struct WireAlignment {
    std::vector<WirePair> pairs;   ///< in order along the path; empty if no part of the curve matches
    double cost = 0.0;   ///< negative log likelihood

    double followedPx(const WireCurve& curve) const;   ///< length of the curve that runs along the path
};

/// Returns the cheapest alignment (dynamic time warping with free ends). `seen` holds the knots of the path, in order.
WireAlignment alignWire(const ProjectedKnots& projected, const WireCurve& curve, const WireModel& model);

}   // namespace angiopose::core

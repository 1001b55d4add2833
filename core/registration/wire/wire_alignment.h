#pragma once

#include "core/registration/wire/observed_knots.h"
#include "core/registration/wire/observed_steps.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Knot of a path matched to a point of the curve.
struct WirePair {
    std::size_t knot = 0;   ///< index in the path
    std::size_t point = 0;   ///< index in the curve
    WireMove move;   ///< move that led here; none for the first pair
    double lengthMm = 0.0;   ///< length of wire or vessel that it represents
};

/// Monotonic alignment of a curve with a path.
struct WireAlignment {
    std::vector<WirePair> pairs;   ///< in order; empty: no part of the curve matches the path
    double cost = 0.0;   ///< −log likelihood

    double followedPx(const WireCurve& curve) const;   ///< length of the curve that runs along the path
};

/// Cheapest alignment (dynamic time warping with free ends). `seen` contains the knots of the path, in order.
WireAlignment alignWire(const ObservedKnots& seen, const WireCurve& curve, const WireModel& model);

}   // namespace angiopose::core

#pragma once

#include "core/registration/wire/observed_knots.h"
#include "core/registration/wire/observed_steps.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// A knot of a way beside a point of the curve.
struct WirePair {
    std::size_t knot = 0;   ///< place in the way
    std::size_t point = 0;   ///< of the curve
    WireMove move;   ///< that led here; none: the first
    double lengthMm = 0.0;   ///< of wire or vessel, that it counts for
};

/// A curve laid along a way, neither going back.
struct WireAlignment {
    std::vector<WirePair> pairs;   ///< in order; empty: nothing of the curve lies along the way
    double cost = 0.0;   ///< −log likelihood

    double followedPx(const WireCurve& curve) const;   ///< of the curve, that lies along the way
};

/// The cheapest alignment (dynamic time warping whose ends are free). `seen`: the knots of the way, in order.
WireAlignment alignWire(const SeenKnots& seen, const WireCurve& curve, const WireModel& model);

}   // namespace angiopose::core

#pragma once

#include "core/registration/wire/seen_knots.h"
#include "core/registration/wire/wire_curve.h"
#include "core/registration/wire/wire_model.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// A knot of a way beside a point of the curve.
struct WirePair {
    std::size_t knot = 0;   ///< place in the way
    std::size_t point = 0;   ///< of the curve
    double measurements = 0.0;   ///< how many it counts for
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

#pragma once

#include "core/registration/wire/observed_knots.h"
#include "core/registration/wire/observed_steps.h"
#include "core/registration/wire/wire_curve.h"
#include "core/registration/wire/wire_model.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace angiopose::core {

/// Path through the tree as a sequence of adjacent knots.
struct TreeWay {
    std::vector<std::size_t> knots;   ///< from a tree end to the end of the branch that contains the wire tip
    bool isCurveTurned = false;   ///< whether the curve is traversed from its last point to its first
    double cost = 0.0;   ///< negative log likelihood

    bool operator==(const TreeWay&) const = default;
};

/// Returns up to `most` possible paths of a wire through the tree at one pose, best first, limited to the best path for
/// each pair of first and last branch (ALGORITHMS §6.22). Wires enter at the eight widest ends of the tree. `seen`
/// contains all knots. `shouldContinue` is called before each entry.
std::vector<TreeWay> likelyWays(const TreeKnots& knots, const ObservedKnots& seen, const WireCurve& curve,
                                const WireModel& model, std::size_t most, const std::function<bool()>& shouldContinue);

}   // namespace angiopose::core

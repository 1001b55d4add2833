#pragma once

#include "core/registration/wire/observed_knots.h"
#include "core/registration/wire/observed_steps.h"
#include "core/registration/wire/wire_curve.h"
#include "core/registration/wire/wire_model.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace angiopose::core {

/// Path through the tree: knots, each adjacent to the previous one.
struct TreeWay {
    std::vector<std::size_t> knots;   ///< from an end of the tree to the end of the branch that contains the wire tip
    bool isCurveTurned = false;   ///< whether the curve is used in reverse, last point first
    double cost = 0.0;   ///< −log likelihood

    bool operator==(const TreeWay&) const = default;
};

/// Finds the possible paths of a wire through the tree as seen at one pose (ALGORITHMS §6.22), best first, at most
/// `most`: the best one for each pair of first and last branch. Wires enter at the eight widest ends. `seen` contains
/// all knots. `shouldContinue` is called between entries.
std::vector<TreeWay> likelyWays(const TreeKnots& knots, const ObservedKnots& seen, const WireCurve& curve,
                                const WireModel& model, std::size_t most, const std::function<bool()>& shouldContinue);

}   // namespace angiopose::core

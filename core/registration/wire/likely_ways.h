#pragma once

#include "core/registration/wire/observed_knots.h"
#include "core/registration/wire/observed_steps.h"
#include "core/registration/wire/wire_curve.h"
#include "core/registration/wire/wire_model.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace angiopose::core {

/// A way through the tree: knots, each a neighbour of the one before.
struct TreeWay {
    std::vector<std::size_t> knots;   ///< from an end of the tree to the end of the branch where the wire ends
    bool isCurveTurned = false;   ///< the curve's last point comes first
    double cost = 0.0;   ///< −log likelihood

    bool operator==(const TreeWay&) const = default;
};

/// The ways through the tree that a wire may take as one pose shows it (ALGORITHMS §6.22), best first, at most `most`:
/// of each pair of branches where it may begin and end the best. Wires come in at ends, the widest eight. `seen`: all
/// knots. `shouldContinue` is asked between entries.
std::vector<TreeWay> likelyWays(const TreeKnots& knots, const SeenKnots& seen, const WireCurve& curve,
                                const WireModel& model, std::size_t most, const std::function<bool()>& shouldContinue);

}   // namespace angiopose::core

#pragma once

#include "core/registration/wire/projected_knots.h"
#include "core/registration/wire/step_cost.h"
#include "core/registration/wire/wire_curve.h"
#include "core/registration/wire/wire_model.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace angiopose::core {

/// Path through the tree as a sequence of adjacent knots.
struct TreePath {
    std::vector<std::size_t> knots;   ///< from a tree end to the end of the branch that contains the wire tip
    bool isCurveReversed = false;   ///< whether the curve is traversed from its last point to its first
    double cost = 0.0;   ///< negative log likelihood

    bool operator==(const TreePath&) const = default;
};

/// Returns up to `maxPaths` possible paths of a wire through the tree at one pose, best first, limited to the best path
/// for each pair of first and last branch (ALGORITHMS §6.22). Wires enter at the eight widest ends of the tree. `seen`
/// contains all knots. `shouldContinue` is called before each entry.
std::vector<TreePath> findLikelyPaths(const TreeKnots& knots, const ProjectedKnots& projected, const WireCurve& curve,
                                      const WireModel& model, std::size_t maxPaths,
                                      const std::function<bool()>& shouldContinue);

}   // namespace angiopose::core

#pragma once

#include "core/registration/wire/wire_curve.h"
#include "core/registration/wire/wire_model.h"

namespace angiopose::core {

/// Length of a move that ends at a given knot and point, and cost of its shape (see WireModel).
struct StepCost {
    double lengthMm = 0.0;   ///< length along the wire or along the centerline, whichever is longer
    double cost = 0.0;   ///< cost of the shape difference
};

/// Returns the cost of a move. `treeStepPx` is the vector from its first to its last knot; the move ends at point `k`.
inline StepCost stepCost(const WireModel& model, const Eigen::Vector2d& treeStepPx, const WireCurve& curve,
                         std::size_t k, std::size_t points, double mmPerPx)
{
    const Eigen::Vector2d& along = curve.tangents[k];
    const Eigen::Vector2d treeStepMm =
        mmPerPx * Eigen::Vector2d(treeStepPx.dot(along), along.x() * treeStepPx.y() - along.y() * treeStepPx.x());
    const double wireStepMm = mmPerPx * (curve.alongPx[k] - curve.alongPx[k - points]);
    const double lengthMm = std::max({treeStepMm.norm(), wireStepMm, WireModel::minStepMm});
    return {lengthMm, model.shapeCost(treeStepMm, wireStepMm, lengthMm)};
}

}   // namespace angiopose::core

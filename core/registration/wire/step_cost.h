#pragma once

#include "core/registration/wire/wire_curve.h"
#include "core/registration/wire/wire_model.h"

namespace angiopose::core {

/// Length of a move that ends at a given knot and point, and cost of its shape (see WireModel).
struct StepCost {
    double lengthMm = 0.0;   ///< length along the wire or along the centerline, whichever is longer
    double cost = 0.0;   ///< cost of the shape difference
};

/// Returns the cost of a move. `ofTreePx` is the vector from its first to its last knot; the move ends at point `k`.
inline StepCost stepCost(const WireModel& model, const Eigen::Vector2d& ofTreePx, const WireCurve& curve, std::size_t k,
                         std::size_t points, double mmPerPx)
{
    const Eigen::Vector2d& along = curve.tangents[k];
    const Eigen::Vector2d ofTree =
        mmPerPx * Eigen::Vector2d(ofTreePx.dot(along), along.x() * ofTreePx.y() - along.y() * ofTreePx.x());
    const double ofWireMm = mmPerPx * (curve.alongPx[k] - curve.alongPx[k - points]);
    const double lengthMm = std::max({ofTree.norm(), ofWireMm, WireModel::minStepMm});
    return {lengthMm, model.shapeCost(ofTree, ofWireMm, lengthMm)};
}

}   // namespace angiopose::core

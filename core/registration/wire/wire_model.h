#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::core {

/// How a wire lies in its vessel (ALGORITHMS §6.22): anywhere in the lumen and a little beyond it, for it pulls the
/// vessel straight; what it is off the axis changes slowly along it. Chosen on made-up trees (wire_table --world made-up).
struct WireModel {
    double offAxisMm = 1.5;   ///< 1-σ, whatever the vessel's width
    double offAxisOfRadius = 0.5;   ///< 1-σ, in radii: evenly spread over a disc
    double correlationMm = 15.0;   ///< so much of the wire counts as one measurement
    double farCost = 4.5;   ///< of one such measurement off the tree, at most: three sigmas
    double skipCost = 3.0;   ///< of one that runs on where the tree is not: before it begins, or beyond its ends
    double directionDeg = 25.0;   ///< 1-σ between wire and axis
    double reachMm = 0.0;   ///< 1-σ of what the pose is off still

    double varianceMm2(double radiusMm) const
    {
        const double ofLumenMm = offAxisOfRadius * radiusMm;
        return offAxisMm * offAxisMm + ofLumenMm * ofLumenMm + reachMm * reachMm;
    }

    /// −log likelihood of one measurement. `alongTree`: the step to the knot from the one before, px, none at the first;
    /// `alongWire`: unit.
    double costOf(double squaredMm2, double varianceMm2, const Eigen::Vector2d& alongTree,
                  const Eigen::Vector2d& alongWire) const
    {
        const double lengthPx = alongTree.norm();
        const double cosine = lengthPx > leastStepPx ? alongTree.dot(alongWire) / lengthPx : 1.0;
        const double sigmas = std::acos(std::clamp(cosine, -1.0, 1.0)) / (directionDeg * std::numbers::pi / 180.0);
        return std::min(farCost, 0.5 * squaredMm2 / varianceMm2 + 0.5 * sigmas * sigmas +
                                     std::log(varianceMm2 / this->varianceMm2(0.0)));
    }

    static constexpr double leastStepPx = 1.0;   ///< shorter ones, seen along the ray, tell no direction
};

}   // namespace angiopose::core

#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace angiopose::core {

/// How an alignment goes on: so many knots and points further.
struct WireMove {
    std::size_t knots = 0;
    std::size_t points = 0;
};

inline constexpr std::array<WireMove, 6> wireMoves{{{1, 1}, {2, 1}, {1, 2}, {3, 1}, {1, 0}, {0, 1}}};

/// How a wire lies in its vessel (ALGORITHMS §6.22): anywhere in the lumen and a little beyond it, for it pulls the
/// vessel straight. What it is off the axis changes slowly along it, so it runs nearly as the axis does: its shape
/// tells more than its place. Chosen on made-up trees (wire_table --world made-up).
struct WireModel {
    double offAxisMm = 1.5;   ///< 1-σ, whatever the vessel's width
    double offAxisOfRadius = 0.5;   ///< 1-σ, in radii: evenly spread over a disc
    double placeMm = 30.0;   ///< so much of the wire counts as one measurement of its place
    double farCost = 4.5;   ///< of one such measurement, at most: three sigmas
    double turn = 0.2;   ///< 1-σ of what a step of the wire goes aside from the axis' step, of its length
    double stretch = 0.3;   ///< 1-σ of what it is shorter or longer
    double shapeMm = 7.5;   ///< so much of the wire counts as one measurement of its shape
    double turnedCost = 4.5;   ///< of one such measurement, at most
    double skipPerMm =
        0.5;   ///< cost where the wire runs on and the tree does not: before it begins, or beyond its ends
    double maxSigmas = 4.0;   ///< off the axis; farther is another vessel
    double reachMm = 0.0;   ///< 1-σ of what the pose is off still

    double varianceMm2(double radiusMm) const
    {
        const double ofLumenMm = offAxisOfRadius * radiusMm;
        return offAxisMm * offAxisMm + ofLumenMm * ofLumenMm + reachMm * reachMm;
    }

    bool isBeside(double squaredMm2, double varianceMm2) const
    {
        return squaredMm2 < maxSigmas * maxSigmas * varianceMm2;
    }

    /// −log likelihood of a mm of wire so far from the axis.
    double placeCostPerMm(double squaredMm2, double varianceMm2) const
    {
        const double widening = 0.5 * std::log(varianceMm2 / this->varianceMm2(0.0));
        return std::min(farCost, 0.5 * squaredMm2 / varianceMm2 + widening) / placeMm;
    }

    /// −log likelihood of a step: of the tree (along the wire, and across it) and of the wire, mm; `lengthMm`: the
    /// longer.
    double shapeCost(const Eigen::Vector2d& ofTree, double ofWireMm, double lengthMm) const
    {
        const double aside = ofTree.y() / turn;
        const double longer = (ofTree.x() - ofWireMm) / stretch;
        return std::min(turnedCost * lengthMm, 0.5 * (aside * aside + longer * longer) / lengthMm) / shapeMm;
    }

    static constexpr double minStepMm = 0.02;   ///< shorter ones tell nothing
};

}   // namespace angiopose::core

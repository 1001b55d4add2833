#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace angiopose::core {

/// Move of an alignment: number of knots and of curve points to advance.
struct WireMove {
    std::size_t knots = 0;
    std::size_t points = 0;
};

inline constexpr std::array<WireMove, 6> wireMoves{{{1, 1}, {2, 1}, {1, 2}, {3, 1}, {1, 0}, {0, 1}}};

/// Model of a guidewire or catheter in its vessel (ALGORITHMS §6.22). The wire may lie anywhere in the lumen and,
/// because it straightens the vessel, slightly beyond. Its distance from the centerline varies slowly along its length,
/// and it runs nearly parallel to the centerline; its shape is therefore more informative than its position. The
/// parameters were chosen on synthetic trees (wire_table --world made-up).
struct WireModel {
    double offAxisMm = 1.5;   ///< 1-σ distance from the centerline, independent of the vessel's width
    double offAxisOfRadius = 0.5;   ///< additional 1-σ distance in vessel radii, for a uniform distribution over a disk
    double positionLengthMm = 30.0;   ///< length of wire that counts as one position measurement
    double maxPositionCost = 4.5;   ///< maximum cost of one position measurement, reached at 3 σ
    double turn =
        0.2;   ///< 1-σ lateral difference between a step of the wire and of the centerline, relative to the step
    double stretch = 0.3;   ///< 1-σ difference in length, relative to the step length
    double shapeMm = 7.5;   ///< length of wire that counts as one shape measurement
    double maxShapeCost = 4.5;   ///< maximum cost of one shape measurement
    double skipPerMm = 0.5;   ///< cost per mm by which the wire extends beyond either end of the path
    double maxSigmas = 4.0;   ///< maximum distance from the centerline, beyond which lies another vessel
    double reachMm = 0.0;   ///< 1-σ of the remaining pose error

    double varianceMm2(double radiusMm) const
    {
        const double lumenToleranceMm = offAxisOfRadius * radiusMm;
        return offAxisMm * offAxisMm + lumenToleranceMm * lumenToleranceMm + reachMm * reachMm;
    }

    bool isNearAxis(double squaredMm2, double varianceMm2) const
    {
        return squaredMm2 < maxSigmas * maxSigmas * varianceMm2;
    }

    /// Returns −log likelihood per mm of wire at this distance from the centerline.
    double positionCostPerMm(double squaredMm2, double varianceMm2) const
    {
        const double widening = 0.5 * std::log(varianceMm2 / this->varianceMm2(0.0));
        return std::min(maxPositionCost, 0.5 * squaredMm2 / varianceMm2 + widening) / positionLengthMm;
    }

    /// Returns the negative log likelihood of a step's shape: `treeStepMm` is the step of the tree along and across the
    /// wire, `wireStepMm` the step of the wire, and `lengthMm` the longer of the two, all in mm.
    double shapeCost(const Eigen::Vector2d& treeStepMm, double wireStepMm, double lengthMm) const
    {
        const double aside = treeStepMm.y() / turn;
        const double longer = (treeStepMm.x() - wireStepMm) / stretch;
        return std::min(maxShapeCost * lengthMm, 0.5 * (aside * aside + longer * longer) / lengthMm) / shapeMm;
    }

    static constexpr double minStepMm = 0.02;   ///< shorter steps carry no information
};

}   // namespace angiopose::core

#pragma once

#include "core/vessel/tree_knots.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Traced curve on which a knot may lie.
struct KnotCandidate {
    double offsetMm = 0.0;   ///< distance across the vessel from the predicted position
    double cost = 0.0;   ///< negative log likelihood without regard to other knots
    int curve = -1;
    double probability = 0.0;   ///< posterior given all knots: the output
};

/// Candidates of one knot in one view before matching; a knot without candidates remains unmatched.
struct KnotChoice {
    Eigen::Vector2d normal = Eigen::Vector2d::Zero();   ///< normal of the projected vessel
    std::vector<KnotCandidate> candidates;
};

/// Expected similarity of the offsets of neighboring knots.
struct NeighborModel {
    double noiseMm = 0.1;   ///< 1-σ of one offset
    double strain = 0.15;   ///< 1-σ of the offset change per mm along the tree
};

/// Matches knots to curves by sum-product message passing along the tree (ALGORITHMS §11.3): computes the probability
/// of each candidate of every knot; the remainder to 1 is the probability that the knot is not visible in the image.
/// The result is exact, because the links form a forest.
void matchAlongTree(const TreeKnots& knots, const NeighborModel& model, std::vector<KnotChoice>& choices);

}   // namespace angiopose::core

#pragma once

#include "core/vessel/tree_knots.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Curve that a knot may belong to.
struct KnotCandidate {
    double offsetMm = 0.0;   ///< across the vessel, from the predicted position
    double cost = 0.0;   ///< negative log likelihood of the candidate on its own
    int curve = -1;
    double probability = 0.0;   ///< posterior given all knots: the output
};

/// Observations of one knot in one view before matching; a knot without candidates is unseen.
struct KnotChoice {
    Eigen::Vector2d normal = Eigen::Vector2d::Zero();   ///< normal of the projected vessel
    std::vector<KnotCandidate> candidates;
};

/// Similarity of the offsets of neighboring knots.
struct NeighborModel {
    double noiseMm = 0.1;   ///< 1-σ of one offset
    double strain = 0.15;   ///< 1-σ of the change per mm along the tree
};

/// Matches knots and curves by sum-product along the tree (ALGORITHMS §11.3): computes for every knot the probabilities
/// of its candidates; the remainder to 1 is the probability that the image does not show it. Exact, because the links
/// form a forest.
void matchAlongTree(const TreeKnots& knots, const NeighborModel& model, std::vector<KnotChoice>& choices);

}   // namespace angiopose::core

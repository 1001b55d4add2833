#pragma once

#include "core/vessel/tree_knots.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// A curve that a knot may belong to.
struct KnotCandidate {
    double offsetMm = 0.0;   ///< across the vessel, from where the model expects it
    double cost = 0.0;   ///< negative log of how likely it is by itself
    int curve = -1;
    double probability = 0.0;   ///< by all knots together: the answer
};

/// What is known of one knot in one view before matching; one without candidates is not seen.
struct KnotChoice {
    Eigen::Vector2d normal = Eigen::Vector2d::Zero();   ///< of the projected vessel
    std::vector<KnotCandidate> candidates;
};

/// How alike the offsets of neighbours are.
struct NeighborModel {
    double noiseMm = 0.1;   ///< 1-σ of one offset
    double strain = 0.15;   ///< 1-σ of the change per mm along the tree
};

/// Who belongs to whom, by sum-product along the tree (ALGORITHMS §11.3): for every knot the probabilities of its
/// candidates; what is left to 1 is the probability that the image does not show it. Exact, as the links are a forest.
void matchAlongTree(const TreeKnots& knots, const NeighborModel& model, std::vector<KnotChoice>& choices);

}   // namespace angiopose::core

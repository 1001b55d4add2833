#pragma once

#include "core/registration/problem/registration_problem.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Segment of one branch between two bifurcations.
struct BranchPiece {
    int branchIndex = 0;   ///< index into TreeSamples::branchIds, or index of the curve
    std::size_t from = 0;   ///< index of the first point
    std::size_t to = 0;   ///< one past the last point
};

/// Incidence of a segment and a junction at one of its ends.
struct PieceAtJunction {
    int piece = 0;
    int junction = 0;
};

/// Tree cut into segments at every bifurcation, in the order of the tree's points, with the incidence of segments and
/// junctions. The graph is free of cycles: where vessels form a ring, one incidence is dropped.
struct BranchPieces {
    std::vector<BranchPiece> pieces;
    std::vector<PieceAtJunction> joints;
    int junctionCount = 0;
};

/// Two branches meet if an end of one lies within 2.5 mm of the other.
inline constexpr double branchesTouchMm = 2.5;
BranchPieces branchPieces(const TreeSamples& tree);

/// Overload for any concatenated curves with ascending `curveIndex`; `touching` is in the unit of the points.
BranchPieces branchPieces(const std::vector<Eigen::Vector3d>& points, const std::vector<int>& curveIndex,
                          double touching);

}   // namespace angiopose::core

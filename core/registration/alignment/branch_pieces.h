#pragma once

#include "core/registration/problem/registration_problem.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// A stretch of one branch between two places where the tree parts.
struct BranchPiece {
    int branchIndex = 0;   ///< into TreeSamples::branchIds, or the number of the curve
    std::size_t from = 0;   ///< first point
    std::size_t to = 0;   ///< one past the last
};

/// A piece that begins or ends at a place where vessels meet.
struct PieceAtJunction {
    int piece = 0;
    int junction = 0;
};

/// The tree cut wherever a branch leaves another: pieces in the order of the tree's points, and what meets where.
/// Without cycles: where vessels run in a ring, one of its joints is left out.
struct BranchPieces {
    std::vector<BranchPiece> pieces;
    std::vector<PieceAtJunction> joints;
    int junctionCount = 0;
};

/// Branches meet where the end of one lies within 2.5 mm of another.
inline constexpr double branchesTouchMm = 2.5;
BranchPieces branchPieces(const TreeSamples& tree);

/// The same of any curves, one after the other, `curveIndex` ascending; in the unit of their points.
BranchPieces branchPieces(const std::vector<Eigen::Vector3d>& points, const std::vector<int>& curveIndex,
                          double touching);

}   // namespace angiopose::core

#pragma once

#include "core/registration/problem/registration_problem.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Section of one branch between two bifurcations.
struct BranchPiece {
    int branchIndex = 0;   ///< index into TreeSamples::branchIds, or index of the curve
    std::size_t from = 0;   ///< first point
    std::size_t to = 0;   ///< one past the last
};

/// Piece that begins or ends at a junction.
struct PieceAtJunction {
    int piece = 0;
    int junction = 0;
};

/// Tree cut at every bifurcation: the pieces in the order of the tree's points, and which of them meet at which
/// junction. The result is free of cycles: where vessels form a ring, one junction is left out.
struct BranchPieces {
    std::vector<BranchPiece> pieces;
    std::vector<PieceAtJunction> joints;
    int junctionCount = 0;
};

/// Branches meet where the end of one lies within 2.5 mm of another.
inline constexpr double branchesTouchMm = 2.5;
BranchPieces branchPieces(const TreeSamples& tree);

/// Overload for arbitrary concatenated curves with ascending `curveIndex`; lengths are in the unit of the points.
BranchPieces branchPieces(const std::vector<Eigen::Vector3d>& points, const std::vector<int>& curveIndex,
                          double touching);

}   // namespace angiopose::core

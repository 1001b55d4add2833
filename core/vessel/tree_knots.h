#pragma once

#include "core/vessel/vessel_tree.h"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace angiopose::core {

/// A link between two neighboring knots of the tree.
struct KnotLink {
    std::size_t parent = 0;
    std::size_t child = 0;
    double lengthMm = 0.0;
};

/// The tree as a forest of knots, which are a few millimeters apart along all branches and linked where branches meet.
/// Each loop (such as the circle of Willis) is cut at one link, listed in `cuts`.
struct TreeKnots {
    std::vector<Eigen::Vector3d> positions;   ///< patient LPS, mm
    std::vector<Eigen::Vector3d> tangents;   ///< unit vectors along the branch
    std::vector<double> radiusMm;   ///< 0 if unknown
    std::vector<double> lengthMm;   ///< length of the branch section that a knot represents
    std::vector<std::uint8_t> isUsed;   ///< 0 for knots of excluded branches, which are not compared with any image
    std::vector<std::size_t> firstOfBranch;   ///< index per branch of the tree, plus the end index
    std::vector<KnotLink> links;   ///< each knot is a child at most once, before any link of which it is the parent
    std::vector<KnotLink> cuts;   ///< links that would each close a loop

    std::size_t size() const { return positions.size(); }
    std::size_t branchOf(std::size_t knot) const;

    /// Returns the distances along the tree, mm; infinite between disconnected components.
    Eigen::MatrixXd distancesAlongTree() const;
};

/// Returns knots about `spacingMm` apart, including both ends of every branch.
TreeKnots treeKnots(const VesselTree& tree, const std::vector<int>& excludedBranchIds, double spacingMm);

}   // namespace angiopose::core

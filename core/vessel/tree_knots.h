#pragma once

#include "core/vessel/vessel_tree.h"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Two knots that are neighbours along the tree.
struct KnotLink {
    std::size_t parent = 0;
    std::size_t child = 0;
    double lengthMm = 0.0;
};

/// The tree as a forest: places a few millimetres apart along all branches, joined where branches meet. Loops (the
/// circle of Willis) are cut at one place each, which `cuts` tells.
struct TreeKnots {
    std::vector<Eigen::Vector3d> places;   ///< patient LPS mm
    std::vector<Eigen::Vector3d> tangents;   ///< unit, along the branch
    std::vector<double> radiusMm;   ///< 0 where unknown
    std::vector<double> lengthMm;   ///< of the branch that a knot stands for
    std::vector<std::uint8_t> isUsed;   ///< 0: of an excluded branch, looks at no image
    std::vector<std::size_t> firstOfBranch;   ///< per branch of the tree, and the end
    std::vector<KnotLink> links;   ///< every knot is the child of at most one, and stands there before it is a parent
    std::vector<KnotLink> cuts;   ///< would close a loop each

    std::size_t size() const { return places.size(); }
    std::size_t branchOf(std::size_t knot) const;

    /// Distances along the tree, mm; infinite between pieces that do not connect.
    Eigen::MatrixXd distancesAlongTree() const;
};

/// Knots about `spacingMm` apart, both ends of every branch among them.
TreeKnots treeKnots(const VesselTree& tree, const std::vector<int>& excludedBranchIds, double spacingMm);

}   // namespace angiopose::core

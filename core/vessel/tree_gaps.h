#pragma once

#include "core/support/result.h"
#include "core/vessel/vessel_tree.h"

#include <vector>

namespace angiopose::core {

/// A place where two pieces of a tree probably belong together.
struct TreeGap {
    int fromBranchId = 0;   ///< it ends at the gap
    int toBranchId = 0;
    Eigen::Vector3d fromInPatient = Eigen::Vector3d::Zero();
    Eigen::Vector3d toInPatient = Eigen::Vector3d::Zero();   ///< an end of the other branch, or a point of its side
    bool toIsEnd = false;   ///< join the two; else one leaves the other
    double distanceMm = 0.0;
    double directionAgreement = 0.0;   ///< 1: the way over goes straight on from both sides, 0: across, -1: back
};

/// Where a tree that is in pieces is best mended: for each piece but the largest the most plausible gap to another one,
/// the most plausible first (near, and straight on). Gaps longer than `longestMm` are no gaps.
std::vector<TreeGap> findGaps(const VesselTree& tree, double longestMm = 25.0);

/// How many pieces do not touch one another.
int pieceCount(const VesselTree& tree);

/// The tree with a gap closed: the two branches become one where both end there (see `joinedOver`), else the one is led
/// on to the other's side.
Result<VesselTree> mended(const VesselTree& tree, const TreeGap& gap);

}   // namespace angiopose::core
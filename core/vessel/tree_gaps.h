#pragma once

#include "core/support/result.h"
#include "core/vessel/vessel_tree.h"

#include <vector>

namespace angiopose::core {

/// A gap where two components of a tree probably connect.
struct TreeGap {
    int fromBranchId = 0;   ///< branch that ends at the gap
    int toBranchId = 0;
    Eigen::Vector3d fromInPatient = Eigen::Vector3d::Zero();
    Eigen::Vector3d toInPatient = Eigen::Vector3d::Zero();   ///< an end of the other branch, or a point along it
    bool toIsEnd = false;   ///< whether the two branches join end to end; if false, one leaves the other
    double distanceMm = 0.0;
    double directionAgreement = 0.0;   ///< 1 if straight on from both sides, 0 if perpendicular, -1 if backward
};

/// Finds the gaps of a disconnected tree. For each component except the largest, returns the most plausible gap (short
/// and straight) to another component, sorted by plausibility. Gaps longer than `maxGapMm` are ignored.
std::vector<TreeGap> findGaps(const VesselTree& tree, double maxGapMm = 25.0);

/// Returns the number of connected components.
int componentCount(const VesselTree& tree);

/// Closes a gap: the two branches become one if the gap lies at ends of both (see `joinAtEnds`); otherwise one branch
/// is extended to the side of the other.
Result<VesselTree> closeGap(const VesselTree& tree, const TreeGap& gap);

}   // namespace angiopose::core

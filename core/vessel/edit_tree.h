#pragma once

#include "core/support/result.h"
#include "core/vessel/vessel_tree.h"

#include <cstddef>
#include <string>

// Edits of a vessel tree: each takes a tree and gives the edited one, ids of untouched branches unchanged. A branch
// that does not exist, or an edit that would leave nothing, is an error in words for the user.

namespace angiopose::core {

/// How near two branches must come to be connected, mm; as for `findNodes`.
inline constexpr double touchingMm = 1.5;

/// Without the branch and all that leaves it, directly or not.
Result<VesselTree> withoutSubtree(const VesselTree& tree, int branchId);

/// Without end branches that are shorter, or on average thinner, than asked; the shortest go first, until none is left.
/// A branch of unknown radius is never too thin.
Result<VesselTree> pruned(const VesselTree& tree, double minLengthMm, double minRadiusMm);

/// The branch parted at its `point`-th point, which ends the first part; the second begins with the next point and is a
/// branch of its own with a new id. Both parts need two points.
Result<VesselTree> cutAt(const VesselTree& tree, int branchId, std::size_t point);

/// Two branches made one over their nearest ends: id, name and direction of the first; the gap is bridged straight.
Result<VesselTree> joined(const VesselTree& tree, int firstId, int secondId);

/// An end of a branch: its first or its last point.
struct BranchEnd {
    int branchId = 0;
    bool atBack = true;
};

/// As `joined`, over the ends given.
Result<VesselTree> joinedOver(const VesselTree& tree, const BranchEnd& first, const BranchEnd& second);

/// The branch led on from one of its ends, straight, to a point: of another branch that it then touches.
Result<VesselTree> extendedTo(const VesselTree& tree, const BranchEnd& end, const Eigen::Vector3d& pointInPatient);

/// The branch as a smoothing spline: bends narrower than about `widthMm` are taken out; its ends stay.
Result<VesselTree> smoothedBranch(const VesselTree& tree, int branchId, double widthMm);

/// Index of the branch's point nearest to a place; the branch must exist.
std::size_t nearestPoint(const VesselTree& tree, int branchId, const Eigen::Vector3d& pointInPatient);

Result<VesselTree> renamed(const VesselTree& tree, int branchId, const std::string& name);

/// The branch counted as of a generation; −1: unknown.
Result<VesselTree> withGeneration(const VesselTree& tree, int branchId, int generation);

}   // namespace angiopose::core
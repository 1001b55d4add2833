#pragma once

#include "core/support/result.h"
#include "core/vessel/vessel_tree.h"

#include <cstddef>
#include <string>

// Edits of a vessel tree. Each function takes a tree and returns the edited tree; the ids of unaffected branches stay
// unchanged. A nonexistent branch, or an edit that would leave nothing, is reported as an error to the user.

namespace angiopose::core {

/// Maximum distance at which two branches count as connected, mm; as in `findNodes`.
inline constexpr double maxContactMm = 1.5;

/// Removes the branch and all its descendants.
Result<VesselTree> removeSubtree(const VesselTree& tree, int branchId);

/// Removes end branches that are too short or, on average, too thin, shortest first, until none remains. A branch of
/// unknown radius never counts as too thin.
Result<VesselTree> pruneTree(const VesselTree& tree, double minLengthMm, double minRadiusMm);

/// Splits the branch after its point `point`. The second part begins with the next point and gets a new id. Each part
/// needs at least two points.
Result<VesselTree> splitAt(const VesselTree& tree, int branchId, std::size_t point);

/// Joins two branches at their nearest ends and bridges the gap with a straight line. The result keeps id, name and
/// direction of the first branch.
Result<VesselTree> joinBranches(const VesselTree& tree, int firstId, int secondId);

/// An end of a branch: its first or its last point.
struct BranchEnd {
    int branchId = 0;
    bool isLastPoint = true;
};

/// Joins two branches as `joined` does, at the given ends.
Result<VesselTree> joinAtEnds(const VesselTree& tree, const BranchEnd& first, const BranchEnd& second);

/// Extends the branch straight from one of its ends to a point, usually on another branch, which it then touches.
Result<VesselTree> extendBranchTo(const VesselTree& tree, const BranchEnd& end, const Eigen::Vector3d& pointInPatient);

/// Smooths the branch with a smoothing spline, which removes bends narrower than about `widthMm` and keeps both ends.
Result<VesselTree> smoothBranch(const VesselTree& tree, int branchId, double widthMm);

/// Returns the index of the branch's point nearest to a position; the branch must exist.
std::size_t nearestPoint(const VesselTree& tree, int branchId, const Eigen::Vector3d& pointInPatient);

Result<VesselTree> renameBranch(const VesselTree& tree, int branchId, const std::string& name);

/// Sets the generation of the branch; −1 means unknown.
Result<VesselTree> assignGeneration(const VesselTree& tree, int branchId, int generation);

}   // namespace angiopose::core

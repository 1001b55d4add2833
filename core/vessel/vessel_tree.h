#pragma once

#include "core/support/message.h"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::core {

/// One branch of a vessel tree: an ordered centerline in patient LPS, mm.
struct VesselBranch {
    int id = 0;   ///< stable and unique in the tree
    std::string name;   ///< anatomical label; may be empty
    std::vector<Eigen::Vector3d> pointsInPatient;   ///< at least two points
    std::vector<double> radiusMm;   ///< one per point, or empty if unknown
    int generation = -1;   ///< 0 for branches that begin at the root, 1 for their branches, …; -1 if unknown

    double lengthMm() const;
};

/// Branches of one vessel tree. Branches that meet need not have a point in common: findNodes connects ends that touch.
struct VesselTree {
    std::vector<VesselBranch> branches;

    std::size_t pointCount() const;
    const VesselBranch* find(int branchId) const;
};

/// A bifurcation, where two or more branches meet, or a free end.
struct VesselNode {
    Eigen::Vector3d pointInPatient;
    std::vector<int> branchIds;   ///< branches that end at this node or pass through it

    bool isBifurcation() const { return branchIds.size() > 1; }
};

/// Returns the bifurcations and free ends. A branch end closer than `toleranceMm` to a point of another branch forms
/// one node with that branch.
std::vector<VesselNode> findNodes(const VesselTree& tree, double toleranceMm = 1.5);

/// Returns the length-weighted centroid of the whole tree in patient LPS, mm: the pivot of pose edits and OBJ
/// parameters.
Eigen::Vector3d centroidInPatient(const VesselTree& tree);

/// Returns the unit tangents of an ordered curve by central differences. Where neighboring points coincide, the
/// previous tangent is used.
std::vector<Eigen::Vector3d> tangentsOf(const std::vector<Eigen::Vector3d>& points);

/// Returns the tree resampled every `spacingMm` of arc length (ends kept, radii interpolated, duplicates removed).
VesselTree resampled(const VesselTree& tree, double spacingMm);

VesselTree withoutBranches(const VesselTree& tree, const std::vector<int>& excludedIds);

/// Returns whether the total length of all branches is at most twice the greatest width, which suggests a ball or block
/// rather than vessels. False without radii.
bool isCompact(const VesselTree& tree);

/// Returns the diagonal of the bounding box.
double extentMm(const VesselTree& tree);

/// Returns whether size and width are typical of vessels in CT; if not, the coordinates may have another unit.
bool isPlausibleSize(const VesselTree& tree);

/// Returns the reason why a tree is unusable (no branch, one point, NaN, …); nullopt if it is valid.
std::optional<Message> findProblem(const VesselTree& tree);

}   // namespace angiopose::core

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
    std::vector<Eigen::Vector3d> pointsInPatient;   ///< at least two
    std::vector<double> radiusMm;   ///< one per point, or empty if unknown
    int generation = -1;   ///< 0 begins at the root, 1 leaves such a branch, …; -1 if unknown

    double lengthMm() const;
};

/// Branches of one vessel tree. Branches that meet need not share a point: findNodes connects ends that touch.
struct VesselTree {
    std::vector<VesselBranch> branches;

    std::size_t pointCount() const;
    const VesselBranch* find(int branchId) const;
};

/// A bifurcation (two or more branches meet) or a free end.
struct VesselNode {
    Eigen::Vector3d pointInPatient;
    std::vector<int> branchIds;   ///< branches that end here or pass through

    bool isBifurcation() const { return branchIds.size() > 1; }
};

/// Returns the bifurcations and free ends. Branch ends closer than `toleranceMm` to a point of another branch form one
/// node with it.
std::vector<VesselNode> findNodes(const VesselTree& tree, double toleranceMm = 1.5);

/// Returns the length-weighted centroid of the whole tree, patient LPS mm: the pivot of pose edits and of OBJ
/// parameters.
Eigen::Vector3d centroidInPatient(const VesselTree& tree);

/// Returns the unit tangents of an ordered curve by central differences; a zero-length neighborhood takes the previous
/// tangent.
std::vector<Eigen::Vector3d> tangentsOf(const std::vector<Eigen::Vector3d>& points);

/// Returns the tree resampled every `spacingMm` of arc length (ends kept, radii interpolated, duplicates removed).
VesselTree resampled(const VesselTree& tree, double spacingMm);

/// Returns the tree without the branches in `excludedIds`.
VesselTree without(const VesselTree& tree, const std::vector<int>& excludedIds);

/// Whether the total length of all branches is at most twice the greatest width, as for a ball or a block rather than
/// vessels. False without radii.
bool isCompact(const VesselTree& tree);

/// Returns the diagonal of the bounding box.
double acrossMm(const VesselTree& tree);

/// Whether size and width are typical of vessels in CT; if not, the numbers may be in another unit.
bool isUsualSize(const VesselTree& tree);

/// Reports why this tree is unusable (no branch, one point, NaN, …); nothing if it is valid.
std::optional<Message> findProblem(const VesselTree& tree);

}   // namespace angiopose::core
#pragma once

#include "core/support/message.h"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::core {

/// One branch of a vessel tree: an ordered centreline in patient LPS, mm.
struct VesselBranch {
    int id = 0;   ///< stable, unique in the tree
    std::string name;   ///< as labelled; may be empty
    std::vector<Eigen::Vector3d> pointsInPatient;   ///< at least two
    std::vector<double> radiusMm;   ///< one per point, or empty when unknown
    int generation = -1;   ///< 0 begins at the root, 1 leaves such a branch, …; -1 unknown

    double lengthMm() const;
};

/// Branches of one vessel tree. Branches that meet need not share a point: nodes join ends that touch.
struct VesselTree {
    std::vector<VesselBranch> branches;

    std::size_t pointCount() const;
    const VesselBranch* find(int branchId) const;
};

/// A bifurcation (two or more branches meet) or a free end.
struct VesselNode {
    Eigen::Vector3d pointInPatient;
    std::vector<int> branchIds;   ///< the branches that end or pass here

    bool isBifurcation() const { return branchIds.size() > 1; }
};

/// Bifurcations and ends. Branch ends closer than `toleranceMm` to another branch's point are one node with it.
std::vector<VesselNode> findNodes(const VesselTree& tree, double toleranceMm = 1.5);

/// Length-weighted centroid of the whole tree, patient LPS mm: the pivot of pose edits and of OBJ parameters.
Eigen::Vector3d centroidInPatient(const VesselTree& tree);

/// Unit tangents of an ordered curve by central differences; a zero-length neighbourhood inherits its predecessor's.
std::vector<Eigen::Vector3d> tangentsOf(const std::vector<Eigen::Vector3d>& points);

/// The same tree with points every `spacingMm` of arc length (ends kept, radius interpolated; duplicates dropped).
VesselTree resampled(const VesselTree& tree, double spacingMm);

/// The tree without the branches in `excludedIds`.
VesselTree without(const VesselTree& tree, const std::vector<int>& excludedIds);

/// True when all branches together are no longer than twice the greatest width: a ball or a block rather than vessels.
/// Never without radii.
bool isCompact(const VesselTree& tree);

/// Diagonal of the box around all points.
double acrossMm(const VesselTree& tree);

/// False where vessels of a CT are hardly of that size or width: the unit of the numbers may be another.
bool isUsualSize(const VesselTree& tree);

/// What makes this tree unusable (no branch, one point, NaN, …), in words for the user; empty when it is fine.
std::optional<Message> findProblem(const VesselTree& tree);

}   // namespace angiopose::core
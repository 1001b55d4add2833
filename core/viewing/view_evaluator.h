#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/support/result.h"
#include "core/vessel/vessel_tree.h"

#include <vector>

namespace angiopose::core {

/// A short straight segment of a vessel.
struct VesselSegment {
    Eigen::Vector3d midpointInPatient;   ///< midpoint, LPS, mm
    Eigen::Vector3d alongMm;   ///< vector from start to end
    double radiusMm = 0.0;
    int branchId = 0;
};

/// Radius assumed for vessels without radii in the tree, mm.
inline constexpr double assumedRadiusMm = 1.0;

/// Divides the tree into segments of at most one millimeter.
std::vector<VesselSegment> vesselSegmentsOf(const VesselTree& tree);

/// Returns the segments of one branch.
std::vector<VesselSegment> branchSegments(const std::vector<VesselSegment>& pieces, int branchId);

/// Returns the side-branch takeoff: the segments, of all branches that meet there, within `reachMm` of the bifurcation
/// nearest to the branch's first point. Fails if the tree does not have the branch or if the branch meets no other.
Result<std::vector<VesselSegment>> takeoffSegments(const VesselTree& tree, int branchId, double reachMm = 10.0);

/// Visibility of a part of the vessels from one direction (ALGORITHMS §5.9).
struct ViewQuality {
    double foreshortening = 0.0;   ///< 0 if seen at full length, 1 if seen end-on
    double overlap = 0.0;   ///< fraction of its projected area overlapped by itself or other vessels, 0…1

    double cost() const { return foreshortening + overlap; }
};

/// Evaluates the view of a part of the vessels from many directions.
class ViewEvaluator {
public:
    /// `part` contains at least one segment of `all`. Vessels that touch a segment of the part in 3-D do not count as
    /// overlapping that segment.
    ViewEvaluator(std::vector<VesselSegment> part, std::vector<VesselSegment> all);

    /// Evaluates the view from this pose. Segments at or behind the source count as end-on and overlapped.
    ViewQuality from(const RigidTransform& cameraFromPatient) const;

private:
    struct ProjectedSegment;
    ProjectedSegment projectSegment(const RigidTransform& cameraFromPatient, const VesselSegment& piece) const;
    std::vector<double> overlapFractions(const RigidTransform& cameraFromPatient,
                                         const std::vector<ProjectedSegment>& part) const;

    std::vector<VesselSegment> part_, all_;
    double partLengthMm_ = 0.0;
};

/// Part of a branch whose view is evaluated.
enum class EvaluatedPart { Branch, Takeoff };

/// Prepares the evaluation of a branch, or of its takeoff (takeoffSegments), among all vessels of the tree. Fails if
/// the tree does not contain the branch, or for the takeoff of a branch that meets no other branch.
Result<ViewEvaluator> makeViewEvaluator(const VesselTree& tree, int branchId, EvaluatedPart evaluatedPart);

}   // namespace angiopose::core

#pragma once

#include "core/registration/problem/registration_problem.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Segment of one branch between two bifurcations.
struct BranchSegment {
    int branchIndex = 0;   ///< index into TreeSamples::branchIds, or index of the curve
    std::size_t from = 0;   ///< index of the first point
    std::size_t to = 0;   ///< one past the last point
};

/// Connection of a segment with a junction at one of its ends.
struct SegmentIncidence {
    int piece = 0;
    int junction = 0;
};

/// Tree cut into segments at every bifurcation, in the order of the tree's points, with the incidences of segments and
/// junctions. The graph is free of cycles: where vessels form a ring, one incidence is dropped.
struct BranchSegments {
    std::vector<BranchSegment> pieces;
    std::vector<SegmentIncidence> incidences;
    int junctionCount = 0;
};

/// Distance of a branch end from another branch up to which the two branches meet.
inline constexpr double maxBranchGapMm = 2.5;
BranchSegments splitAtBifurcations(const TreeSamples& tree);

/// Overload for any concatenated curves with ascending `curveIndex`; `maxGap` is in the unit of the points.
BranchSegments splitAtBifurcations(const std::vector<Eigen::Vector3d>& points, const std::vector<int>& curveIndex,
                                   double maxGap);

}   // namespace angiopose::core

#pragma once

#include "core/tracing/tree/vessel_graph.h"
#include "core/tracing/volume/voxels/cross_section.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Removes what a tree has leaked into: parts in which wide stretches are mostly less bright than the vessels around
/// `startsMm`. Contrast medium is not thinned on its way down an artery, but the tissue of spleen and kidney holds
/// less of it, and so do veins. Stretches thinner than three voxels are dark by blurring and say nothing; what holds a
/// start stays. `graph` has no loops; ends that are then too short are left to `pruneSpurs`. Returns how many parts
/// were removed.
int dropDimParts(VesselGraph& graph, const BloodFill& fill, const std::vector<Eigen::Vector3d>& startsMm,
                 double voxelMm);

}   // namespace angiopose::core
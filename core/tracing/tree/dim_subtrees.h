#pragma once

#include "core/tracing/tree/vessel_graph.h"
#include "core/tracing/volume/voxels/cross_section.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Removes leakage from a tree: subtrees whose wide segments are mostly dimmer than the vessels around `startsMm`.
/// Contrast agent is not diluted along an artery, but the parenchyma of spleen and kidney contains less of it, as do
/// veins. Segments thinner than three voxels are dimmed by blurring and are ignored; parts with a starting point are
/// kept. `graph` must have no loops; `pruneSpurs` removes ends that are then too short. Returns the number removed.
int removeDimSubtrees(VesselGraph& graph, const PointOpacification& opacification,
                      const std::vector<Eigen::Vector3d>& startsMm, double voxelMm);

}   // namespace angiopose::core

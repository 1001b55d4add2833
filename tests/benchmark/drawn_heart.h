#pragma once

#include "core/imaging/volume.h"
#include "core/vessel/vessel_tree.h"

#include <string>

namespace angiopose::benchmarks {

/// Reads a patient's coronary tree, "lca" or "rca", below ../shared/data. If it is missing, prints the reason to stdout
/// and returns an empty tree.
core::VesselTree coronaryTree(const std::string& side);

/// Draws a heart around a tree: fat, and an opacified ventricle as large as the vessels allow, 2 mm from the nearest;
/// voxels of 0.4 × 0.4 × 0.5 mm with partial volume and noise of 30 HU.
core::Volume drawnHeart(const core::VesselTree& tree, double bloodHu);

}   // namespace angiopose::benchmarks

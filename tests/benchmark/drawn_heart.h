#pragma once

#include "core/imaging/volume.h"
#include "core/vessel/vessel_tree.h"

#include <string>

namespace angiopose::benchmarks {

/// A patient's coronary tree, "lca" or "rca", below ../shared/data; empty, with the reason on stdout, without it.
core::VesselTree coronaryTree(const std::string& side);

/// A heart around a tree: fat, a filled ventricle as large as the vessels leave room for, 2 mm off the nearest; voxels
/// of 0.4 × 0.4 × 0.5 mm with partial volume and noise of 30 HU.
core::Volume drawnHeart(const core::VesselTree& tree, double bloodHu);

}   // namespace angiopose::benchmarks

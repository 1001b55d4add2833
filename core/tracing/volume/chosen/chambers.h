#pragma once

#include "core/tracing/volume/great_vessels/necks.h"
#include "core/tracing/volume/voxels/distance_map.h"

#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Voxels that belong to no vessel of the seeds, though the lumen connects them: vessels taper or stay as they are, so
/// what is reached from every seed only through a neck much narrower than itself has leaked (a vein, a chamber that
/// touches the vessel's wall), and what is much wider than the widest vessel at a seed is a chamber. Ordered; empty
/// when no seed lies in a vessel wide enough to tell.
std::vector<std::uint32_t> voxelsBeyondNecks(const DistanceMap& distances, const Necks& necks);

}   // namespace angiopose::core
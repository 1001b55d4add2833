#pragma once

#include "core/tracing/volume/great_vessels/necks.h"
#include "core/tracing/volume/voxels/distance_map.h"

#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Voxels that belong to no vessel of the seeds although the lumen connects them. Vessels taper or keep their width, so
/// regions that every seed reaches only through a neck much narrower than themselves are leaks (a vein, a chamber that
/// touches the vessel's wall), and regions much wider than the widest vessel at a seed are chambers. Ordered; empty if
/// no seed lies in a vessel wide enough to decide.
std::vector<std::uint32_t> voxelsBeyondNecks(const DistanceMap& distances, const Necks& necks);

}   // namespace angiopose::core
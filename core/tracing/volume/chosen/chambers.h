#pragma once

#include "core/tracing/volume/great_vessels/necks.h"
#include "core/tracing/volume/voxels/distance_map.h"

#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Returns voxels that are connected to the seeds but do not belong to the seeds' vessels. Vessels taper or keep their
/// width, so regions that every seed reaches only through a much narrower neck are leaks (a vein, a chamber touching
/// the vessel wall), and regions much wider than the widest vessel at a seed are chambers. Ascending; empty if no seed
/// lies in a vessel wide enough to decide.
std::vector<std::uint32_t> voxelsBeyondNecks(const DistanceMap& distances, const Necks& necks);

}   // namespace angiopose::core

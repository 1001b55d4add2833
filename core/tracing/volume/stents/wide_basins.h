#pragma once

#include "core/tracing/volume/voxels/distance_map.h"

#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Parts a lumen at its necks: a number from 1 for each voxel in it, the same for what hangs together on a way that is
/// at least `minNeck` times as wide as the narrower of the two at its widest; 0 outside (flooding of the distance map
/// from its summits, Meyer 1994).
std::vector<std::uint32_t> wideBasins(const DistanceMap& distances, double minNeck);

}   // namespace angiopose::core
#pragma once

#include "core/tracing/volume/voxels/distance_map.h"

#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Splits a lumen at its necks by flooding the distance map from its maxima (Meyer 1994). Returns labels from 1 for
/// lumen voxels, equal if they are connected by a path at least `minNeck` times as wide as the maximum width of the
/// narrower part; 0 outside.
std::vector<std::uint32_t> labelWideBasins(const DistanceMap& distances, double minNeck);

}   // namespace angiopose::core

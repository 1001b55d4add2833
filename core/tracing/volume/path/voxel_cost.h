#pragma once

#include "core/tracing/volume/path/path_ground.h"

namespace angiopose::core {

/// What a millimetre of tissue costs, over one in the middle of a vessel; and the least that one costs.
inline constexpr double dearestPerMm = 40.0;
inline constexpr double cheapestPerMm = 1.0 / (1.0 / dearestPerMm + 1.0);

/// What a millimetre through a voxel costs: about 1 in the middle of a vessel of that look, 40 in tissue (ALGORITHMS
/// §9.12).
double costOfVoxel(const PathGround& ground, const Eigen::Vector3i& voxel, const VesselLook& look);

/// The same for a value that is known to be that share of a tube's middle.
double costOfTube(double value, double share, const VesselLook& look);

}   // namespace angiopose::core

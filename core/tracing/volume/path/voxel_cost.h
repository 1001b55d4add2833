#pragma once

#include "core/tracing/volume/path/path_ground.h"

namespace angiopose::core {

/// Cost per millimeter in tissue and in the middle of a vessel: the highest and the lowest possible.
inline constexpr double dearestPerMm = 40.0;
inline constexpr double cheapestPerMm = 1.0 / (1.0 / dearestPerMm + 1.0);

/// Cost per millimeter through a voxel: about 1 in the middle of a vessel of that look, 40 in tissue (ALGORITHMS
/// §9.12).
double costOfVoxel(const PathGround& ground, const Eigen::Vector3i& voxel, const VesselLook& look);

/// Same as `costOfVoxel` for a value with a known tube share.
double costOfTube(double value, double share, const VesselLook& look);

}   // namespace angiopose::core

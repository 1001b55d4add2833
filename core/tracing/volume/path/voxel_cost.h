#pragma once

#include "core/tracing/volume/path/path_ground.h"

namespace angiopose::core {

/// What a millimetre through a voxel costs: about 1 in the middle of a vessel of that look, 40 in tissue (ALGORITHMS
/// §9.12).
double costOfVoxel(const PathGround& ground, const Eigen::Vector3i& voxel, const VesselLook& look);

}   // namespace angiopose::core

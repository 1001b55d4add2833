#pragma once

#include "core/tracing/volume/path/tube_detector.h"

namespace angiopose::core {

/// Cost per millimeter in tissue (the highest possible) and in the center of a vessel (the lowest possible).
inline constexpr double maxCostPerMm = 40.0;
inline constexpr double minCostPerMm = 1.0 / (1.0 / maxCostPerMm + 1.0);

/// Returns the cost per millimeter through a voxel: about 1 in the center of a vessel of that appearance, 40 in tissue
/// (ALGORITHMS §9.12).
double costOfVoxel(const TubeDetector& detector, const Eigen::Vector3i& voxel, const VesselAppearance& appearance);

/// Returns the same cost as `costOfVoxel` for a value with a known tube resemblance.
double costOfTube(double value, double fraction, const VesselAppearance& appearance);

}   // namespace angiopose::core

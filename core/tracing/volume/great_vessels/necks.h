#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/distance_map.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Returns the path from a voxel to the center of the surrounding vessel by steepest ascent in the distance map.
std::vector<std::uint32_t> pathToCenter(std::uint32_t voxel, const DistanceMap& distances);

/// Narrowest widths along the paths from the seeds.
struct Necks {
    std::vector<std::uint16_t> units;   ///< narrowest width on the widest path, in distance units; 0 if unconnected
    double seedRadiusMm = 0.0;   ///< radius of the widest vessel at a seed
};

/// Computes the widest paths within a mask from the vessel centers at the seeds (LPS, mm); ignores seeds outside the
/// mask. Incomplete when stopped.
Necks computeNecks(const VoxelMask& mask, const DistanceMap& distances,
                   const std::vector<Eigen::Vector3d>& seedsInPatient, TracingProgress& progress);

/// Returns the narrowest width, in mm, on the widest path between two voxels; 0 if they are not connected. The search
/// extends at most `aroundMm` beyond the box around both.
double neckMm(const DistanceMap& distances, const Eigen::Vector3i& from, const Eigen::Vector3i& to, double aroundMm);

}   // namespace angiopose::core

#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/distance_map.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Path from a voxel to the middle of the surrounding vessel, by steepest ascent of the distances.
std::vector<std::uint32_t> wayToMiddle(std::uint32_t voxel, const DistanceMap& distances);

/// Narrowest widths along the paths from the seeds.
struct Necks {
    std::vector<std::uint16_t> units;   ///< per voxel: neck of the widest path, in distance units; 0: not connected
    double seedRadiusMm = 0.0;   ///< radius of the widest vessel at a seed
};

/// Widest paths within a mask from the middle of the vessels at the seeds (LPS mm); seeds outside the mask are ignored.
/// Incomplete when stopped.
Necks necksOf(const VoxelMask& mask, const DistanceMap& distances, const std::vector<Eigen::Vector3d>& seedsInPatient,
              TracingProgress& progress);

/// Narrowest place, in mm, on the widest path between two voxels that leaves the box around both by at most `aroundMm`;
/// 0 if they are not connected.
double neckMm(const DistanceMap& distances, const Eigen::Vector3i& from, const Eigen::Vector3i& to, double aroundMm);

}   // namespace angiopose::core
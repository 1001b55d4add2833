#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/distance_map.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace angiopose::core {

/// From a voxel to the middle of the vessel around it: the way up the distances.
std::vector<std::uint32_t> wayToMiddle(std::uint32_t voxel, const DistanceMap& distances);

/// How wide the ways from the seeds are.
struct Necks {
    std::vector<std::uint16_t> units;   ///< for each voxel the narrowest place on the widest way to it from any seed,
                                        ///< in the units of the distances; 0 where no way leads
    double seedRadiusMm = 0.0;   ///< of the widest vessel at a seed
};

/// Ways within a mask from the middle of the vessels at the seeds (LPS mm); seeds in nothing are ignored. Incomplete
/// when stopped.
Necks necksOf(const VoxelMask& mask, const DistanceMap& distances, const std::vector<Eigen::Vector3d>& seedsInPatient,
              TracingProgress& progress);

/// The narrowest place on the widest way between two voxels, in mm, that strays from the box around both by no more
/// than `aroundMm`; 0 where no way leads.
double neckMm(const DistanceMap& distances, const Eigen::Vector3i& from, const Eigen::Vector3i& to, double aroundMm);

}   // namespace angiopose::core
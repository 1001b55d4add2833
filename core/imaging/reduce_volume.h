#pragma once

#include "core/imaging/volume.h"

#include <cstddef>
#include <functional>
#include <optional>

namespace angiopose::core {

/// Box of voxel indices from `low` up to, but excluding, `high`.
struct VoxelRange {
    Eigen::Vector3i low = Eigen::Vector3i::Zero();
    Eigen::Vector3i high = Eigen::Vector3i::Zero();
};

/// Returns the voxels inside a box in patient coordinates: all if no box is given, none if it lies outside the volume.
VoxelRange voxelRangeIn(const VolumeGeometry& geometry, const std::optional<Eigen::AlignedBox3d>& boxInPatient);

/// Returns the volume with blocks of voxels averaged to at most `maxVoxels`; the blocks are as nearly cubic as integer
/// sizes allow, and stored units are kept. Returns nullopt if `shouldContinue`, called between slices, returns false or
/// if the range is empty.
std::optional<Volume> downsample(const Volume& volume, const VoxelRange& range, std::size_t maxVoxels,
                                 const std::function<bool()>& shouldContinue);

/// Averages blocks of the given size; blocks at the far border contain fewer voxels.
std::optional<Volume> averageBlocks(const Volume& volume, const VoxelRange& range, const Eigen::Vector3i& block,
                                    const std::function<bool()>& shouldContinue);

}   // namespace angiopose::core

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

/// Returns the voxels inside a box in patient coordinates: all if no box is given, none if the box lies outside the
/// volume.
VoxelRange voxelRangeIn(const VolumeGeometry& geometry, const std::optional<Eigen::AlignedBox3d>& boxInPatient);

/// Averages blocks of voxels, as nearly cubic as integer block sizes allow, to at most `maxVoxels`; stored units are
/// kept. Returns nothing if `shouldContinue`, called between slices, returns false or the range is empty.
std::optional<Volume> downsample(const Volume& volume, const VoxelRange& range, std::size_t maxVoxels,
                                 const std::function<bool()>& shouldContinue);

/// Does the same for blocks of the given size; blocks at the far border contain fewer voxels.
std::optional<Volume> averageBlocks(const Volume& volume, const VoxelRange& range, const Eigen::Vector3i& block,
                                    const std::function<bool()>& shouldContinue);

}   // namespace angiopose::core

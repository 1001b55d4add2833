#pragma once

#include "core/imaging/volume.h"

#include <cstddef>
#include <functional>
#include <optional>

namespace angiopose::core {

/// Voxels from `low` up to, but without, `high`.
struct VoxelRange {
    Eigen::Vector3i low = Eigen::Vector3i::Zero();
    Eigen::Vector3i high = Eigen::Vector3i::Zero();
};

/// Which voxels lie within a box of the patient; all where `box` is not given, empty where it lies beside the volume.
VoxelRange voxelsIn(const VolumeGeometry& geometry, const std::optional<Eigen::AlignedBox3d>& boxInPatient);

/// Means over blocks of voxels as nearly cubic as whole numbers of voxels allow, so that no more than `maxVoxels` are
/// left; the stored units are kept. `shouldContinue` is asked between slices: nothing comes back once it says no, or
/// where the range is empty.
std::optional<Volume> reduced(const Volume& volume, const VoxelRange& range, std::size_t maxVoxels,
                              const std::function<bool()>& shouldContinue);

/// The same over blocks of that many voxels; at the far rim they hold fewer.
std::optional<Volume> meansOfBlocks(const Volume& volume, const VoxelRange& range, const Eigen::Vector3i& block,
                                    const std::function<bool()>& shouldContinue);

}   // namespace angiopose::core

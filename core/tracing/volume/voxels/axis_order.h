#pragma once

#include "core/imaging/volume.h"

#include <array>
#include <cstddef>

namespace angiopose::core {

/// Box of voxels, from `low` up to but excluding `high`.
struct VoxelBox {
    Eigen::Vector3i low = Eigen::Vector3i::Zero();
    Eigen::Vector3i high = Eigen::Vector3i::Zero();

    bool isEmpty() const { return (high.array() <= low.array()).any(); }
    bool operator==(const VoxelBox&) const = default;
};

/// Maps voxel indices along the patient axes (i left, j posterior, k superior, as closely as the stored axes allow) to
/// the stored order, so that results do not depend on how a scan is stored.
struct AxisOrder {
    VolumeGeometry geometry;   ///< geometry of the reordered voxels
    std::ptrdiff_t first = 0;   ///< stored index of voxel (0, 0, 0)
    std::array<std::ptrdiff_t, 3> strides{};

    std::size_t stored(int i, int j, int k) const
    {
        return static_cast<std::size_t>(first + i * strides[0] + j * strides[1] + k * strides[2]);
    }
    VoxelBox box() const { return {Eigen::Vector3i::Zero(), geometry.size}; }
};

AxisOrder patientAxisOrder(const VolumeGeometry& stored);

/// Returns the order restricted to `box`, with indices starting at its low corner.
AxisOrder crop(const AxisOrder& order, const VoxelBox& box);
VolumeGeometry crop(const VolumeGeometry& geometry, const VoxelBox& box);

/// Returns `box` enlarged by `margin` voxels on all sides, within the volume.
VoxelBox enlarge(const VoxelBox& box, int margin, const VolumeGeometry& within);

}   // namespace angiopose::core

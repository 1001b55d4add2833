#pragma once

#include "core/imaging/volume.h"

#include <array>
#include <cstddef>

namespace angiopose::core {

/// A box of voxels: from `low` up to, but without, `high`.
struct VoxelBox {
    Eigen::Vector3i low = Eigen::Vector3i::Zero();
    Eigen::Vector3i high = Eigen::Vector3i::Zero();

    bool isEmpty() const { return (high.array() <= low.array()).any(); }
    bool operator==(const VoxelBox&) const = default;
};

/// The same voxels counted along the patient's axes: i to the left, j to the back, k to the head, as near as the stored
/// axes allow. Work in this order does not depend on how a scan happens to be stored.
struct AxisOrder {
    VolumeGeometry geometry;   ///< of the counted voxels
    std::ptrdiff_t first = 0;   ///< where voxel (0, 0, 0) is stored
    std::array<std::ptrdiff_t, 3> strides{};

    std::size_t stored(int i, int j, int k) const
    {
        return static_cast<std::size_t>(first + i * strides[0] + j * strides[1] + k * strides[2]);
    }
    VoxelBox box() const { return {Eigen::Vector3i::Zero(), geometry.size}; }
};

AxisOrder patientAxisOrder(const VolumeGeometry& stored);

/// The part within `box`, counted from its low corner.
AxisOrder cropped(const AxisOrder& order, const VoxelBox& box);
VolumeGeometry cropped(const VolumeGeometry& geometry, const VoxelBox& box);

/// `box` grown by `margin` voxels to all sides, as far as the volume goes.
VoxelBox grown(const VoxelBox& box, int margin, const VolumeGeometry& within);

}   // namespace angiopose::core
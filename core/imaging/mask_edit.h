#pragma once

#include "core/imaging/volume_slice.h"

#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Whether both grids have the same voxels at the same positions.
bool isSameGrid(const VolumeGeometry& a, const VolumeGeometry& b);

/// Linear indices of voxels in a mask.
using VoxelIndices = std::vector<std::uint32_t>;

inline std::uint32_t voxelIndex(const VolumeGeometry& geometry, const Eigen::Vector3i& voxel)
{
    return static_cast<std::uint32_t>(geometry.index(voxel.x(), voxel.y(), voxel.z()));
}

/// A set of flipped voxels, run-length encoded in storage order and therefore small even for large volumes. Applying
/// the same change again undoes it.
struct MaskChange {
    struct Run {
        std::uint32_t first = 0;
        std::uint32_t count = 0;
        bool operator==(const Run&) const = default;
    };
    std::vector<Run> runs;

    std::size_t voxelCount() const;
};

MaskChange makeMaskChange(VoxelIndices voxels);   ///< accepts voxels in any order; duplicates are removed
void flip(VoxelMask& mask, const MaskChange& change);   ///< flips the voxels: 0 becomes 1, nonzero becomes 0

/// A box in patient coordinates (LPS, mm).
struct BoundingBox {
    Eigen::Vector3d lowInPatient = Eigen::Vector3d::Zero();
    Eigen::Vector3d highInPatient = Eigen::Vector3d::Zero();
};
/// Returns the bounding box of all voxels of a change, which must not be empty.
BoundingBox boxOf(const VolumeGeometry& geometry, const MaskChange& change);

/// Returns half the slice thickness: voxels within this distance belong to the slice, others to a neighboring slice.
inline double halfThicknessMm(const SliceGrid& slice)
{
    return 0.499 * slice.thicknessMm;
}

}   // namespace angiopose::core

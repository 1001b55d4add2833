#pragma once

#include "core/imaging/volume_slice.h"

#include <cstdint>
#include <vector>

namespace angiopose::core {

/// The same voxels at the same places.
bool isSameGrid(const VolumeGeometry& a, const VolumeGeometry& b);

/// Places of voxels in a mask.
using VoxelPlaces = std::vector<std::uint32_t>;

inline std::uint32_t placeOf(const VolumeGeometry& geometry, const Eigen::Vector3i& voxel)
{
    return static_cast<std::uint32_t>(geometry.index(voxel.x(), voxel.y(), voxel.z()));
}

/// Voxels that go into a mask or out of it, in runs along the order in which they are stored: small, however large the
/// volume. The same change takes them back.
struct MaskChange {
    struct Run {
        std::uint32_t first = 0;
        std::uint32_t count = 0;
        bool operator==(const Run&) const = default;
    };
    std::vector<Run> runs;

    std::size_t voxelCount() const;
};

MaskChange changeOf(VoxelPlaces voxels);   ///< in any order, none twice in the change
void flip(VoxelMask& mask, const MaskChange& change);   ///< what is 0 becomes 1, all else 0

/// A box of the patient, LPS mm.
struct TouchedBox {
    Eigen::Vector3d lowInPatient = Eigen::Vector3d::Zero();
    Eigen::Vector3d highInPatient = Eigen::Vector3d::Zero();
};
/// Around all voxels of a change, which must not be empty.
TouchedBox boxOf(const VolumeGeometry& geometry, const MaskChange& change);

/// Half of the thickness of a slice in which voxels are the slice's own: the slice beside begins there.
inline double halfOf(const SliceGrid& slice)
{
    return 0.499 * slice.thicknessMm;
}

}   // namespace angiopose::core

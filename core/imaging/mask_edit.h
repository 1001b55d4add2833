#pragma once

#include "core/imaging/volume_slice.h"

#include <cstdint>
#include <vector>

namespace angiopose::core {

/// The same voxels at the same places.
bool isSameGrid(const VolumeGeometry& a, const VolumeGeometry& b);

/// Places of voxels in a mask.
using VoxelPlaces = std::vector<std::uint32_t>;

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

enum class MaskAim { Paint, Erase };

/// What a brush does on its way: of a path, all that lies within the radius.
struct MaskBrush {
    MaskAim aim = MaskAim::Paint;
    double radiusMm = 2.0;
    const Volume* scan = nullptr;   ///< only voxels whose value in it is not below `leastValue`; null: all
    double leastValue = 0.0;
};

/// The part of a stroke between two places of the pointer.
struct BrushStep {
    Eigen::Vector3d fromInPatient;
    Eigen::Vector3d toInPatient;
};

/// The voxels that are not yet as the brush wants them: those whose part of space the slice cuts and those that it
/// shows (of a mask coarser than the slice), or those in space.
VoxelPlaces brushedInSlice(const VoxelMask& mask, const SliceGrid& slice, const MaskBrush& brush,
                           const BrushStep& step);
VoxelPlaces brushedInSpace(const VoxelMask& mask, const MaskBrush& brush, const BrushStep& step);

enum class CutSide { Inside, Outside };

/// A closed outline drawn in a slice, cut through what lies within so many mm before and behind it.
struct MaskCut {
    SliceGrid slice;
    std::vector<Eigen::Vector2d> outline;   ///< pixels of the slice
    CutSide side = CutSide::Inside;   ///< what is removed
    double halfDepthMm = 0.0;   ///< 0: the slice alone
};

/// The voxels of the mask that it removes.
VoxelPlaces cutVoxels(const VoxelMask& mask, const MaskCut& cut);

}   // namespace angiopose::core

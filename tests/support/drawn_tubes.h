#pragma once

#include "core/imaging/volume.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace angiopose::test {

/// A straight section of a vessel in the patient, with rounded ends.
struct Tube {
    Eigen::Vector3d fromMm;
    Eigen::Vector3d toMm;
    double radiusMm = 3.0;
    double endRadiusMm = 0.0;   ///< radius at `toMm`; 0: the same as at `fromMm`
};

/// A grid parallel to the patient axes around `centerMm`.
core::VolumeGeometry gridAround(const Eigen::Vector3d& centerMm, const Eigen::Vector3i& size,
                                const Eigen::Vector3d& spacingMm);

/// The same positions in the patient stored in another order: axis a of the new grid is axis `order[a]` of the old one,
/// reversed if `flipped[a]`.
core::VolumeGeometry restored(const core::VolumeGeometry& grid, const std::array<int, 3>& order,
                              const std::array<bool, 3>& flipped);

/// Signed distance from a point to the wall of the nearest tube, mm; negative inside.
double distanceToWall(const std::vector<Tube>& tubes, const Eigen::Vector3d& pointMm);

core::VoxelMask drawnMask(const core::VolumeGeometry& grid, const std::vector<Tube>& tubes);

/// Tubes of blood in soft tissue next to air, in HU, without noise; the walls are 1 mm wide.
core::Volume tubesInTissue(const core::VolumeGeometry& grid, const std::vector<Tube>& tubes);

}   // namespace angiopose::test

#include "core/tracing/volume/voxels/touching_vessels.h"

#include "core/support/quantile.h"
#include "core/tracing/volume/voxels/voxel_components.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace angiopose::core {
namespace {

constexpr std::uint16_t maxWallUnits = 269;   ///< 1.05 voxels in distance units: maximum for a voxel at the wall
constexpr std::uint16_t minInnerUnits = 486;   ///< 1.9 voxels in distance units: minimum for no blurring from the wall
constexpr std::size_t minInnerOfTrunk = 12;   ///< minimum voxels for measuring the lumen level
constexpr double minDifference = 0.15;   ///< minimum difference of opacification; along one aorta it varies by 0.1

double fillOf(std::uint32_t voxel, const VolumeGeometry& grid, const VoxelOpacification& opacification)
{
    const Eigen::Vector3i at = grid.voxelAt(voxel);
    return opacification(at.x(), at.y(), at.z());
}

double medianFill(const std::vector<std::uint32_t>& voxels, const VolumeGeometry& grid,
                  const VoxelOpacification& opacification)
{
    std::vector<double> fills;
    fills.reserve(voxels.size());
    for (const std::uint32_t voxel : voxels) {
        fills.push_back(fillOf(voxel, grid, opacification));
    }
    return medianOf(std::move(fills));
}

}   // namespace

std::vector<std::uint32_t> differentlyOpacifiedVoxels(const DistanceMap& distances,
                                                      const std::vector<std::uint16_t>& necks,
                                                      const VoxelOpacification& opacification)
{
    const VolumeGeometry& grid = distances.geometry;
    std::vector<std::uint32_t> vesselVoxels;
    VoxelMask beyondContact(grid);
    for (std::uint32_t voxel = 0; voxel < necks.size(); ++voxel) {
        if (distances.units[voxel] < minInnerUnits || necks[voxel] == 0) {
            continue;
        }
        if (necks[voxel] > maxWallUnits) {
            vesselVoxels.push_back(voxel);
        } else {
            beyondContact.voxels[voxel] = 1;
        }
    }
    std::vector<std::uint32_t> different;
    if (vesselVoxels.size() < minInnerOfTrunk) {
        return different;
    }
    const double blood = medianFill(vesselVoxels, grid, opacification);
    for (const VoxelComponent& piece : connectedComponents(beyondContact, minInnerOfTrunk)) {
        if (std::abs(medianFill(piece, grid, opacification) - blood) > minDifference) {
            different.insert(different.end(), piece.begin(), piece.end());
        }
    }
    std::sort(different.begin(), different.end());
    return different;
}

}   // namespace angiopose::core

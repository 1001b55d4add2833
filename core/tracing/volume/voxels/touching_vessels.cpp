#include "core/tracing/volume/voxels/touching_vessels.h"

#include "core/support/quantile.h"
#include "core/tracing/volume/voxels/voxel_pieces.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace angiopose::core {
namespace {

constexpr std::uint16_t touch = 269;   ///< 1.05 voxels in distance units: maximum for a voxel at the wall
constexpr std::uint16_t inner = 486;   ///< 1.9 voxels in distance units: minimum for no blurring from the wall
constexpr std::size_t minInnerOfTrunk = 12;   ///< minimum voxels for measuring the lumen level
constexpr double minDifference = 0.15;   ///< minimum difference of opacification; along one aorta it varies by 0.1

double fillOf(std::uint32_t voxel, const VolumeGeometry& grid, const VoxelFill& fill)
{
    const Eigen::Vector3i at = grid.voxelAt(voxel);
    return fill(at.x(), at.y(), at.z());
}

double medianFill(const std::vector<std::uint32_t>& voxels, const VolumeGeometry& grid, const VoxelFill& fill)
{
    std::vector<double> fills;
    fills.reserve(voxels.size());
    for (const std::uint32_t voxel : voxels) {
        fills.push_back(fillOf(voxel, grid, fill));
    }
    return medianOf(std::move(fills));
}

}   // namespace

std::vector<std::uint32_t> voxelsOfOtherBlood(const DistanceMap& distances, const std::vector<std::uint16_t>& necks,
                                              const VoxelFill& fill)
{
    const VolumeGeometry& grid = distances.geometry;
    std::vector<std::uint32_t> own;
    VoxelMask behind(grid);
    for (std::uint32_t voxel = 0; voxel < necks.size(); ++voxel) {
        if (distances.units[voxel] < inner || necks[voxel] == 0) {
            continue;
        }
        if (necks[voxel] > touch) {
            own.push_back(voxel);
        } else {
            behind.voxels[voxel] = 1;
        }
    }
    std::vector<std::uint32_t> others;
    if (own.size() < minInnerOfTrunk) {
        return others;
    }
    const double blood = medianFill(own, grid, fill);
    for (const VoxelPiece& piece : piecesOf(behind, minInnerOfTrunk)) {
        if (std::abs(medianFill(piece, grid, fill) - blood) > minDifference) {
            others.insert(others.end(), piece.begin(), piece.end());
        }
    }
    std::sort(others.begin(), others.end());
    return others;
}

}   // namespace angiopose::core

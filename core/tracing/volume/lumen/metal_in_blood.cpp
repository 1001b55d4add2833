#include "core/tracing/volume/lumen/metal_in_blood.h"

#include "core/tracing/volume/stents/thin_stent.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace angiopose::core {
namespace {

constexpr double maxBoneHu = 2000.0;
constexpr double maxBoneFill = 5.0;   ///< the same limit as opacification, for scans without Hounsfield units
constexpr double solidReachMm = 6.0;   ///< no stent, even if blurred, is bright on all sides to this distance
constexpr double aroundMetalMm = 2.0;   ///< margin around the brightest voxels, for their blur and thinner struts
constexpr double besideWiresMm = 3.0;   ///< distance beyond the blur of the struts
constexpr double brightFill = 1.6;
constexpr double minBesideFill = 0.7;
constexpr double minBesideShare = 0.38;   ///< minimum lumen fraction of non-bright voxels; sternal wires have 0.3

/// Returns the six positions at distance `reach` along the axes.
std::array<Eigen::Vector3i, 6> sidesOf(const Eigen::Vector3i& voxel, const Eigen::Vector3i& reach)
{
    const Eigen::Vector3i x(reach.x(), 0, 0);
    const Eigen::Vector3i y(0, reach.y(), 0);
    const Eigen::Vector3i z(0, 0, reach.z());
    return {voxel - x, voxel + x, voxel - y, voxel + y, voxel - z, voxel + z};
}

/// Samples the surroundings of one component along the axes.
class Surroundings {
public:
    Surroundings(const VolumeGeometry& grid, const VoxelFill& fill)
        : grid_(grid), fill_(fill), solidReach_(voxelsIn(solidReachMm)), beside_(voxelsIn(besideWiresMm))
    {
    }

    bool isSolidAt(const Eigen::Vector3i& voxel) const
    {
        return std::ranges::all_of(sidesOf(voxel, solidReach_), [this](const Eigen::Vector3i& at) {
            return grid_.contains(at) && fill_(at.x(), at.y(), at.z()) > brightFill;
        });
    }

    void countBeside(const Eigen::Vector3i& voxel)
    {
        for (const Eigen::Vector3i& at : sidesOf(voxel, beside_)) {
            const double fill = grid_.contains(at) ? fill_(at.x(), at.y(), at.z()) : 2.0 * brightFill;
            seen_ += fill <= brightFill ? 1 : 0;
            blood_ += fill >= minBesideFill && fill <= brightFill ? 1 : 0;
        }
    }

    bool isBlood() const { return static_cast<double>(blood_) > minBesideShare * static_cast<double>(seen_); }

private:
    Eigen::Vector3i voxelsIn(double mm) const { return (mm / grid_.spacingMm.array()).round().cast<int>().max(2); }

    const VolumeGeometry& grid_;
    const VoxelFill& fill_;
    Eigen::Vector3i solidReach_;
    Eigen::Vector3i beside_;
    std::size_t seen_ = 0;
    std::size_t blood_ = 0;
};

double maxBone(const BloodLevel& level)
{
    return level.isHu ? (maxBoneHu - level.tissue) / level.contrast() : maxBoneFill;
}

bool isStent(const VoxelPiece& piece, const VolumeGeometry& grid, const VoxelFill& fill)
{
    Surroundings around(grid, fill);
    for (const std::uint32_t voxel : piece) {
        if (around.isSolidAt(grid.voxelAt(voxel))) {
            return false;
        }
        around.countBeside(grid.voxelAt(voxel));
    }
    return around.isBlood() || isThinStent(piece, grid, fill);
}

/// Returns the voxels of a component that are near `metal`.
VoxelPiece partAround(const VoxelPiece& metal, const VoxelPiece& piece, const VolumeGeometry& grid)
{
    const VoxelBox box = boxAround(metal, grid, aroundMetalMm);
    VoxelMask isNear(cropped(grid, box));
    const Eigen::Vector3i reach = (aroundMetalMm / grid.spacingMm.array()).round().cast<int>().max(1);
    for (const std::uint32_t voxel : metal) {
        const Eigen::Vector3i at = grid.voxelAt(voxel) - box.low;
        const Eigen::Vector3i low = (at - reach).cwiseMax(0);
        const Eigen::Vector3i high = (at + reach).cwiseMin((isNear.geometry.size.array() - 1).matrix());
        for (int k = low.z(); k <= high.z(); ++k) {
            for (int j = low.y(); j <= high.y(); ++j) {
                std::fill(&isNear.at(low.x(), j, k), &isNear.at(high.x(), j, k) + 1, std::uint8_t{1});
            }
        }
    }
    VoxelPiece part;
    std::ranges::copy_if(piece, std::back_inserter(part), [&](std::uint32_t voxel) {
        const Eigen::Vector3i at = grid.voxelAt(voxel) - box.low;
        return isNear.geometry.contains(at) && isNear.at(at.x(), at.y(), at.z()) != 0;
    });
    return part;
}

}   // namespace

VoxelPiece metalInBlood(const VoxelPiece& piece, const VolumeGeometry& grid, const BloodLevel& level,
                        const VoxelFill& fill)
{
    const double minMetal = maxBone(level);
    VoxelPiece metal;
    std::ranges::copy_if(piece, std::back_inserter(metal), [&](std::uint32_t voxel) {
        const Eigen::Vector3i at = grid.voxelAt(voxel);
        return fill(at.x(), at.y(), at.z()) > minMetal;
    });
    if (metal.empty() || isStent(piece, grid, fill)) {
        return metal.empty() ? VoxelPiece() : piece;
    }
    VoxelPiece part = partAround(metal, piece, grid);
    return isStent(part, grid, fill) ? part : VoxelPiece();
}

}   // namespace angiopose::core

#include "core/tracing/volume/lumen/stent_part.h"

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
constexpr double samplingDistanceMm = 3.0;   ///< distance beyond the blur of the struts
constexpr double brightFill = 1.6;
constexpr double minNeighborOpacification = 0.7;
constexpr double minLumenFraction = 0.38;   ///< minimum lumen fraction of non-bright voxels; sternal wires have 0.3

/// Returns the six positions at distance `reach` along the axes.
std::array<Eigen::Vector3i, 6> axisNeighbors(const Eigen::Vector3i& voxel, const Eigen::Vector3i& reach)
{
    const Eigen::Vector3i x(reach.x(), 0, 0);
    const Eigen::Vector3i y(0, reach.y(), 0);
    const Eigen::Vector3i z(0, 0, reach.z());
    return {voxel - x, voxel + x, voxel - y, voxel + y, voxel - z, voxel + z};
}

/// Samples the surroundings of one component along the axes.
class SurroundingsSampler {
public:
    SurroundingsSampler(const VolumeGeometry& grid, const VoxelOpacification& fill)
        : grid_(grid),
          opacification_(fill),
          solidReach_(voxelsIn(solidReachMm)),
          samplingReach_(voxelsIn(samplingDistanceMm))
    {
    }

    bool isSolidAt(const Eigen::Vector3i& voxel) const
    {
        return std::ranges::all_of(axisNeighbors(voxel, solidReach_), [this](const Eigen::Vector3i& at) {
            return grid_.contains(at) && opacification_(at.x(), at.y(), at.z()) > brightFill;
        });
    }

    void countNeighbors(const Eigen::Vector3i& voxel)
    {
        for (const Eigen::Vector3i& at : axisNeighbors(voxel, samplingReach_)) {
            const double fill = grid_.contains(at) ? opacification_(at.x(), at.y(), at.z()) : 2.0 * brightFill;
            sampleCount_ += fill <= brightFill ? 1 : 0;
            lumenCount_ += fill >= minNeighborOpacification && fill <= brightFill ? 1 : 0;
        }
    }

    bool isMostlyLumen() const
    {
        return static_cast<double>(lumenCount_) > minLumenFraction * static_cast<double>(sampleCount_);
    }

private:
    Eigen::Vector3i voxelsIn(double mm) const { return (mm / grid_.spacingMm.array()).round().cast<int>().max(2); }

    const VolumeGeometry& grid_;
    const VoxelOpacification& opacification_;
    Eigen::Vector3i solidReach_;
    Eigen::Vector3i samplingReach_;
    std::size_t sampleCount_ = 0;
    std::size_t lumenCount_ = 0;
};

double maxBoneOpacification(const LumenLevels& level)
{
    return level.isHu ? (maxBoneHu - level.tissue) / level.contrast() : maxBoneFill;
}

bool isStent(const VoxelComponent& piece, const VolumeGeometry& grid, const VoxelOpacification& fill)
{
    SurroundingsSampler around(grid, fill);
    for (const std::uint32_t voxel : piece) {
        if (around.isSolidAt(grid.voxelAt(voxel))) {
            return false;
        }
        around.countNeighbors(grid.voxelAt(voxel));
    }
    return around.isMostlyLumen() || isThinStent(piece, grid, fill);
}

/// Returns the voxels of a component that are near `metal`.
VoxelComponent voxelsNear(const VoxelComponent& metal, const VoxelComponent& piece, const VolumeGeometry& grid)
{
    const VoxelBox box = enlargedBox(metal, grid, aroundMetalMm);
    VoxelMask isNear(crop(grid, box));
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
    VoxelComponent part;
    std::ranges::copy_if(piece, std::back_inserter(part), [&](std::uint32_t voxel) {
        const Eigen::Vector3i at = grid.voxelAt(voxel) - box.low;
        return isNear.geometry.contains(at) && isNear.at(at.x(), at.y(), at.z()) != 0;
    });
    return part;
}

}   // namespace

VoxelComponent findStentPart(const VoxelComponent& piece, const VolumeGeometry& grid, const LumenLevels& level,
                             const VoxelOpacification& fill)
{
    const double minMetal = maxBoneOpacification(level);
    VoxelComponent metal;
    std::ranges::copy_if(piece, std::back_inserter(metal), [&](std::uint32_t voxel) {
        const Eigen::Vector3i at = grid.voxelAt(voxel);
        return fill(at.x(), at.y(), at.z()) > minMetal;
    });
    if (metal.empty() || isStent(piece, grid, fill)) {
        return metal.empty() ? VoxelComponent() : piece;
    }
    VoxelComponent part = voxelsNear(metal, piece, grid);
    return isStent(part, grid, fill) ? part : VoxelComponent();
}

}   // namespace angiopose::core

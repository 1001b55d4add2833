#include "core/tracing/volume/metal_in_blood.h"

#include "core/tracing/volume/thin_stent.h"

#include <algorithm>
#include <array>

namespace core {
namespace {

constexpr double mostBoneHu = 2000.0;
constexpr double mostBoneFill = 5.0;   ///< in scans without Hounsfield units
constexpr double solidReachMm = 6.0;   ///< bright as far as this to all sides: no stent, blurred as it may be
constexpr double besideMm = 3.0;   ///< beyond what the wires blur
constexpr double brightFill = 1.6;
constexpr double leastBesideFill = 0.7;
constexpr double leastBesideShare = 0.38;   ///< of what is not bright itself; wires in a sternum have 0.3

/// The places so many voxels away along each axis.
std::array<Eigen::Vector3i, 6> sidesOf(const Eigen::Vector3i& voxel, const Eigen::Vector3i& reach)
{
    const Eigen::Vector3i x(reach.x(), 0, 0);
    const Eigen::Vector3i y(0, reach.y(), 0);
    const Eigen::Vector3i z(0, 0, reach.z());
    return {voxel - x, voxel + x, voxel - y, voxel + y, voxel - z, voxel + z};
}

/// Looks along the axes from the voxels of one piece.
class Surroundings {
public:
    Surroundings(const VolumeGeometry& grid, const VoxelFill& fill)
        : grid_(grid), fill_(fill), solidReach_(voxelsIn(solidReachMm)), beside_(voxelsIn(besideMm))
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
            blood_ += fill >= leastBesideFill && fill <= brightFill ? 1 : 0;
        }
    }

    bool isBlood() const { return static_cast<double>(blood_) > leastBesideShare * static_cast<double>(seen_); }

private:
    Eigen::Vector3i voxelsIn(double mm) const { return (mm / grid_.spacingMm.array()).round().cast<int>().max(2); }

    const VolumeGeometry& grid_;
    const VoxelFill& fill_;
    Eigen::Vector3i solidReach_;
    Eigen::Vector3i beside_;
    std::size_t seen_ = 0;
    std::size_t blood_ = 0;
};

double mostBone(const BloodLevel& level)
{
    return level.isHu ? (mostBoneHu - level.tissue) / level.contrast() : mostBoneFill;
}

}   // namespace

bool isMetalInBlood(const VoxelPiece& piece, const VolumeGeometry& grid, const BloodLevel& level, const VoxelFill& fill)
{
    const double leastMetal = mostBone(level);
    const bool isMetal = std::ranges::any_of(piece, [&](std::uint32_t voxel) {
        const Eigen::Vector3i at = grid.voxelAt(voxel);
        return fill(at.x(), at.y(), at.z()) > leastMetal;
    });
    if (!isMetal) {
        return false;
    }
    Surroundings around(grid, fill);
    for (const std::uint32_t voxel : piece) {
        if (around.isSolidAt(grid.voxelAt(voxel))) {
            return false;
        }
        around.countBeside(grid.voxelAt(voxel));
    }
    return around.isBlood() || isThinStent(piece, grid, fill);
}

}   // namespace core

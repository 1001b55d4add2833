#include "core/tracing/volume/coarse_blood.h"

#include "core/imaging/interpolate_grid.h"
#include "core/support/parallel_for.h"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

constexpr double blockMm = 1.5;
constexpr double full = 200.0;
constexpr double mostFill = 1.2;

/// Voxels per block along each axis.
Eigen::Vector3i blockOf(const VolumeGeometry& grid)
{
    return (blockMm / grid.spacingMm.array()).round().max(1.0).min(64.0).cast<int>();
}

VolumeGeometry coarseGrid(const VolumeGeometry& grid, const Eigen::Vector3i& block)
{
    VolumeGeometry coarse = grid;
    coarse.size = (grid.size.array() + block.array() - 1) / block.array();
    coarse.spacingMm = grid.spacingMm.cwiseProduct(block.cast<double>());
    coarse.originInPatient = grid.patientFromVoxel() * (0.5 * (block.cast<double>().array() - 1.0)).matrix();
    return coarse;
}

/// Mean over the voxels from `low` on that lie within the scan.
double meanFill(const VoxelMask& lumen, const VoxelFill& fill, const Eigen::Vector3i& low, const Eigen::Vector3i& block)
{
    const Eigen::Vector3i high = (low + block).cwiseMin(lumen.geometry.size);
    double sum = 0.0;
    for (int k = low.z(); k < high.z(); ++k) {
        for (int j = low.y(); j < high.y(); ++j) {
            for (int i = low.x(); i < high.x(); ++i) {
                const double share = fill(i, j, k);
                sum += share >= 0.5 && lumen.at(i, j, k) == 0 ? 0.0 : std::clamp(share, 0.0, mostFill);
            }
        }
    }
    return sum / (high - low).prod();
}

}   // namespace

BloodFill CoarseBlood::fill() const
{
    return [this](const Eigen::Vector3d& pointMm) {
        return interpolated(shares.geometry, pointMm,
                            [this](const Eigen::Vector3i& at) { return shares.at(at.x(), at.y(), at.z()) / full; });
    };
}

CoarseBlood coarseBlood(const VoxelMask& lumen, const VoxelFill& fill, int threads, TracingProgress& progress)
{
    const Eigen::Vector3i block = blockOf(lumen.geometry);
    const VolumeGeometry grid = coarseGrid(lumen.geometry, block);
    CoarseBlood blood{VoxelGrid<std::uint8_t>(grid), VoxelMask(grid)};
    const auto fillSlice = [&](std::size_t slice) {
        const int k = static_cast<int>(slice);
        for (int j = 0; j < grid.size.y(); ++j) {
            for (int i = 0; i < grid.size.x(); ++i) {
                const double share = meanFill(lumen, fill, block.cwiseProduct(Eigen::Vector3i(i, j, k)), block);
                blood.shares.at(i, j, k) = static_cast<std::uint8_t>(std::lround(full * share));
                blood.lumen.at(i, j, k) = share >= 0.5 ? 1 : 0;
            }
        }
    };
    parallelFor(static_cast<std::size_t>(grid.size.z()), threads, fillSlice,
                [&](double) { return progress.advance(0.0); });
    return blood;
}

}   // namespace core

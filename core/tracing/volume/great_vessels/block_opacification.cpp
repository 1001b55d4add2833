#include "core/tracing/volume/great_vessels/block_opacification.h"

#include "core/imaging/interpolate_grid.h"
#include "core/support/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace angiopose::core {
namespace {

constexpr double full = 200.0;
constexpr double maxBlockOpacification = 1.2;

/// Extent of one block along one axis: the voxels that it overlaps, or lies between if voxels are longer than blocks.
struct Extent {
    int first = 0;
    std::vector<double> weights;   ///< weights of the voxels from `first` on; their sum is 1
};

/// Creates an extent from `weightOf(n)`, the weight of the voxel with index n; voxels outside the scan do not count.
template <class WeightOf>
Extent extentOf(double low, double high, int size, const WeightOf& weightOf)
{
    Extent extent{std::clamp(static_cast<int>(std::floor(low)), 0, size - 1), {}};
    const int last = std::clamp(static_cast<int>(std::ceil(high)), extent.first, size - 1);
    double sum = 0.0;
    for (int n = extent.first; n <= last; ++n) {
        extent.weights.push_back(std::max(0.0, weightOf(n)));
        sum += extent.weights.back();
    }
    for (double& weight : extent.weights) {
        weight /= std::max(sum, 1e-12);
    }
    return extent;
}

std::vector<Extent> extentsAlong(int size, double spacingMm, double blockMm)
{
    const double ratio = blockMm / spacingMm;
    std::vector<Extent> extents;
    for (double low = 0.0; low < size - 1e-6; low += ratio) {
        const double middle = std::min(low + 0.5 * ratio - 0.5, size - 1.0);   // in voxel indices
        const auto overlap = [&](int n) {
            return std::min(n + 0.5, middle + 0.5 * ratio) - std::max(n - 0.5, middle - 0.5 * ratio);
        };
        const auto between = [&](int n) { return 1.0 - std::abs(n - middle); };
        extents.push_back(ratio >= 1.0 ? extentOf(low, low + ratio, size, overlap)
                                       : extentOf(middle, middle, size, between));
    }
    return extents;
}

/// Mean values over blocks of one size, independent of the scan's voxel size.
class BlockMeans {
public:
    BlockMeans(const VoxelMask& lumen, const VoxelOpacification& fill, double blockMm)
        : lumen_(lumen), opacification_(fill), blockMm_(blockMm)
    {
        for (int axis = 0; axis < 3; ++axis) {
            extents_.push_back(extentsAlong(lumen.geometry.size[axis], lumen.geometry.spacingMm[axis], blockMm));
        }
    }

    VolumeGeometry grid() const
    {
        VolumeGeometry grid = lumen_.geometry;
        grid.spacingMm.setConstant(blockMm_);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            grid.size[static_cast<int>(axis)] = static_cast<int>(extents_[axis].size());
        }
        grid.originInPatient =
            lumen_.geometry.patientFromVoxel() * (0.5 * (blockMm_ / lumen_.geometry.spacingMm.array() - 1.0)).matrix();
        return grid;
    }

    /// Returns the means of one slice of blocks; i varies fastest.
    std::vector<double> slice(std::size_t k) const
    {
        std::vector<double> means;
        means.reserve(extents_[0].size() * extents_[1].size());
        const auto columns = static_cast<std::size_t>(lumen_.geometry.size.x());
        const std::vector<double> plane = planeOf(extents_[2][k]);
        std::vector<double> along(columns);   // means over the block's z and y extent
        for (const Extent& y : extents_[1]) {
            std::fill(along.begin(), along.end(), 0.0);
            for (std::size_t b = 0; b < y.weights.size(); ++b) {
                const double* row = &plane[(static_cast<std::size_t>(y.first) + b) * columns];
                for (std::size_t i = 0; i < columns; ++i) {
                    along[i] += y.weights[b] * row[i];
                }
            }
            for (const Extent& x : extents_[0]) {
                double mean = 0.0;
                for (std::size_t n = 0; n < x.weights.size(); ++n) {
                    mean += x.weights[n] * along[static_cast<std::size_t>(x.first) + n];
                }
                means.push_back(mean);
            }
        }
        return means;
    }

private:
    /// Averages over the block's z extent for all columns and rows at once, because blocks share voxels and
    /// evaluating `opacification_` is expensive.
    std::vector<double> planeOf(const Extent& z) const
    {
        const Eigen::Vector3i& size = lumen_.geometry.size;
        std::vector<double> plane(static_cast<std::size_t>(size.x()) * static_cast<std::size_t>(size.y()), 0.0);
        for (std::size_t c = 0; c < z.weights.size(); ++c) {
            std::size_t at = 0;
            for (int j = 0; j < size.y(); ++j) {
                for (int i = 0; i < size.x(); ++i) {
                    plane[at++] += z.weights[c] * opacificationAt(i, j, z.first + static_cast<int>(c));
                }
            }
        }
        return plane;
    }

    double opacificationAt(int i, int j, int k) const
    {
        const double share = opacification_(i, j, k);
        return share >= 0.5 && lumen_.at(i, j, k) == 0 ? 0.0 : std::clamp(share, 0.0, maxBlockOpacification);
    }

    const VoxelMask& lumen_;
    const VoxelOpacification& opacification_;
    double blockMm_;
    std::vector<std::vector<Extent>> extents_;
};

}   // namespace

PointOpacification BlockOpacification::fill() const
{
    return [this](const Eigen::Vector3d& pointMm) {
        return interpolateTrilinear(shares.geometry, pointMm, [this](const Eigen::Vector3i& at) {
            return shares.at(at.x(), at.y(), at.z()) / full;
        });
    };
}

BlockOpacification averageInBlocks(const VoxelMask& lumen, const VoxelOpacification& fill, int threads,
                                   TracingProgress& progress, double blockMm)
{
    const BlockMeans means(lumen, fill, blockMm);
    const VolumeGeometry grid = means.grid();
    BlockOpacification blocks{VoxelGrid<std::uint8_t>(grid), VoxelMask(grid),
                              std::max(blockMm, lumen.geometry.spacingMm.minCoeff())};
    const auto fillSlice = [&](std::size_t k) {
        std::size_t voxel = grid.index(0, 0, static_cast<int>(k));
        for (const double share : means.slice(k)) {
            blocks.shares.voxels[voxel] = static_cast<std::uint8_t>(std::lround(full * share));
            blocks.lumen.voxels[voxel] = share >= 0.5 ? 1 : 0;
            ++voxel;
        }
    };
    parallelFor(static_cast<std::size_t>(grid.size.z()), threads, fillSlice,
                [&](double) { return progress.advance(0.0); });
    return blocks;
}

}   // namespace angiopose::core

#include "core/imaging/reduce_volume.h"

#include "core/support/parallel_for.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

/// Returns the block size in voxels along each axis: the smallest approximately cubic blocks that are few enough.
Eigen::Vector3i blockSizeFor(const VolumeGeometry& geometry, const Eigen::Vector3i& size, std::size_t maxVoxels)
{
    constexpr double growth = 1.02;
    for (double sideMm = geometry.spacingMm.minCoeff();; sideMm *= growth) {
        const Eigen::Vector3i block =
            (sideMm / geometry.spacingMm.array()).round().max(1.0).min(size.cast<double>().array()).cast<int>();
        const Eigen::Array3i counts = (size.array() + block.array() - 1) / block.array();
        const double count = counts.cast<double>().prod();
        if (count <= static_cast<double>(std::max<std::size_t>(maxVoxels, 1)) ||
            (block.array() == size.array()).all()) {
            return block;
        }
    }
}

VolumeGeometry blockGeometry(const VolumeGeometry& geometry, const VoxelRange& range, const Eigen::Vector3i& block)
{
    VolumeGeometry blocks = geometry;
    blocks.size = ((range.high - range.low).array() + block.array() - 1) / block.array();
    blocks.spacingMm = geometry.spacingMm.cwiseProduct(block.cast<double>());
    blocks.originInPatient = geometry.patientFromVoxel() *
                             (range.low.cast<double>().array() + 0.5 * (block.cast<double>().array() - 1.0)).matrix();
    return blocks;
}

/// Computes the means of one slice of blocks; blocks at the far border contain fewer voxels.
void fillSlice(const Volume& volume, const VoxelRange& range, const Eigen::Vector3i& block, int k, Volume& means)
{
    const Eigen::Vector3i& count = means.geometry.size;
    const auto columns = static_cast<std::size_t>(count.x());
    std::vector<std::int64_t> sums(columns * static_cast<std::size_t>(count.y()), 0);
    const int top = range.low.z() + k * block.z();
    const int bottom = std::min(top + block.z(), range.high.z());
    for (int z = top; z < bottom; ++z) {
        for (int y = range.low.y(); y < range.high.y(); ++y) {
            const std::int16_t* row = &volume.at(range.low.x(), y, z);
            std::int64_t* sum = sums.data() + static_cast<std::size_t>((y - range.low.y()) / block.y()) * columns;
            for (int x = 0, left = range.high.x() - range.low.x(); left > 0; left -= block.x(), ++sum) {
                for (const int end = x + std::min(block.x(), left); x < end; ++x) {
                    *sum += row[x];
                }
            }
        }
    }
    for (int j = 0; j < count.y(); ++j) {
        const int rows = std::min(block.y(), range.high.y() - range.low.y() - j * block.y());
        for (int i = 0; i < count.x(); ++i) {
            const int wide = std::min(block.x(), range.high.x() - range.low.x() - i * block.x());
            const auto at = static_cast<std::size_t>(j) * columns + static_cast<std::size_t>(i);
            const double mean = static_cast<double>(sums[at]) / (static_cast<double>(wide) * rows * (bottom - top));
            means.at(i, j, k) = static_cast<std::int16_t>(std::lround(mean));
        }
    }
}

}   // namespace

VoxelRange voxelRangeIn(const VolumeGeometry& geometry, const std::optional<Eigen::AlignedBox3d>& boxInPatient)
{
    if (!boxInPatient) {
        return {Eigen::Vector3i::Zero(), geometry.size};
    }
    const Eigen::Affine3d voxelFromPatient = geometry.patientFromVoxel().inverse();
    Eigen::AlignedBox3d box;
    for (int corner = 0; corner < 8; ++corner) {
        box.extend(voxelFromPatient * boxInPatient->corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
    }
    return {box.min().array().floor().cast<int>().max(0).matrix(),
            (box.max().array().ceil().cast<int>() + 1).min(geometry.size.array()).matrix()};
}

std::optional<Volume> downsample(const Volume& volume, const VoxelRange& range, std::size_t maxVoxels,
                                 const std::function<bool()>& shouldContinue)
{
    const Eigen::Vector3i size = range.high - range.low;
    if ((size.array() <= 0).any()) {
        return std::nullopt;
    }
    return averageBlocks(volume, range, blockSizeFor(volume.geometry, size, maxVoxels), shouldContinue);
}

std::optional<Volume> averageBlocks(const Volume& volume, const VoxelRange& range, const Eigen::Vector3i& block,
                                    const std::function<bool()>& shouldContinue)
{
    Volume means(blockGeometry(volume.geometry, range, block));
    means.slope = volume.slope;
    means.intercept = volume.intercept;
    const bool isWhole = parallelFor(
        static_cast<std::size_t>(means.geometry.size.z()), threadCount(0),
        [&](std::size_t k) { fillSlice(volume, range, block, static_cast<int>(k), means); },
        [&](double) { return shouldContinue(); });
    return isWhole ? std::optional(std::move(means)) : std::nullopt;
}

}   // namespace angiopose::core

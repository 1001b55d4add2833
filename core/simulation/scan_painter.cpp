#include "core/simulation/scan_painter.h"

#include <vector>

namespace angiopose::core {
namespace {

/// Returns the fraction of each voxel that is lumen.
ScanGrid lumenFractions(const VesselTree& tree, const VolumeGeometry& geometry)
{
    ScanGrid shares(geometry, 0.0F);
    ScanPainter painter(shares);
    const double stepMm = 0.3 * painter.voxelMm();
    for (const VesselBranch& branch : resampled(tree, stepMm).branches) {
        for (std::size_t n = 0; n < branch.pointsInPatient.size(); ++n) {
            const Eigen::Vector3d& center = branch.pointsInPatient[n];
            const double radius = branch.radiusMm[n];
            painter.forEachVoxelAround(
                center, Eigen::Vector3d::Constant(radius + painter.voxelMm()),
                [&](std::size_t voxel, const Eigen::Vector3d& point) {
                    const double share = fractionInside((point - center).norm() - radius, painter.voxelMm());
                    shares.voxels[voxel] = std::max(shares.voxels[voxel], static_cast<float>(share));
                });
        }
    }
    return shares;
}

}   // namespace

VolumeGeometry gridAroundOrigin(const Eigen::Vector3i& size, const Eigen::Vector3d& spacingMm)
{
    VolumeGeometry geometry;
    geometry.size = size;
    geometry.spacingMm = spacingMm;
    geometry.originInPatient = -0.5 * spacingMm.cwiseProduct((size.array() - 1).cast<double>().matrix());
    return geometry;
}

void paintTree(ScanPainter& painter, const VesselTree& tree, const VolumeGeometry& geometry, double hu)
{
    const ScanGrid shares = lumenFractions(tree, geometry);
    for (std::size_t voxel = 0; voxel < shares.voxels.size(); ++voxel) {
        painter.blend(voxel, shares.voxels[voxel], hu);
    }
}

void blurScan(ScanGrid& grid, double sigmaVoxels)
{
    const int reach = static_cast<int>(std::ceil(3.0 * sigmaVoxels));
    std::vector<float> kernel;
    kernel.reserve(2 * static_cast<std::size_t>(reach) + 1);
    float sum = 0.0F;
    for (int n = -reach; n <= reach; ++n) {
        kernel.push_back(static_cast<float>(std::exp(-0.5 * n * n / (sigmaVoxels * sigmaVoxels))));
        sum += kernel.back();
    }
    const Eigen::Vector3i& size = grid.geometry.size;
    const std::ptrdiff_t strides[3] = {1, size.x(), static_cast<std::ptrdiff_t>(size.x()) * size.y()};
    for (int axis = 0; axis < 3; ++axis) {
        const int count = size[axis];
        std::vector<float> line(static_cast<std::size_t>(count));
        const Eigen::Vector3i ends = axis == 0   ? Eigen::Vector3i(1, size.y(), size.z())
                                     : axis == 1 ? Eigen::Vector3i(size.x(), 1, size.z())
                                                 : Eigen::Vector3i(size.x(), size.y(), 1);
        for (int k = 0; k < ends.z(); ++k) {
            for (int j = 0; j < ends.y(); ++j) {
                for (int i = 0; i < ends.x(); ++i) {
                    float* first = &grid.at(i, j, k);
                    for (int n = 0; n < count; ++n) {
                        line[static_cast<std::size_t>(n)] = first[n * strides[axis]];
                    }
                    for (int n = 0; n < count; ++n) {
                        float value = 0.0F;
                        for (std::size_t tap = 0; tap < kernel.size(); ++tap) {
                            const int at = std::clamp(n + static_cast<int>(tap) - reach, 0, count - 1);
                            value += kernel[tap] * line[static_cast<std::size_t>(at)];
                        }
                        first[n * strides[axis]] = value / sum;
                    }
                }
            }
        }
    }
}

Volume storedVolume(const ScanGrid& grid, double noiseHu, const CounterRandom& random)
{
    return roundVolume(grid, random, [noiseHu](double hu, CounterRandom& sliceRandom) {
        return std::clamp(hu + noiseHu * sliceRandom.normal(), -1024.0, 3071.0);
    });
}

}   // namespace angiopose::core

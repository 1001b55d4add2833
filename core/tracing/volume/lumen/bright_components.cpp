#include "core/tracing/volume/lumen/bright_components.h"

#include "core/tracing/volume/voxels/voxel_components.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double joinDistanceMm = 1.25;   ///< half of the maximum gap between voxels of one component
constexpr std::uint8_t betweenComponents = 1;
constexpr std::uint8_t bright = 2;

/// Marks the voxels near bright voxels as `betweenComponents`.
void markSurroundings(VoxelMask& mask)
{
    const Eigen::Vector3i& size = mask.geometry.size;
    const Eigen::Array3i reach = (joinDistanceMm / mask.geometry.spacingMm.array()).floor().cast<int>();
    if ((reach == 0).all()) {
        return;
    }
    const auto markAround = [&](const Eigen::Array3i& voxel) {
        const Eigen::Array3i low = (voxel - reach).max(0);
        const Eigen::Array3i high = (voxel + reach).min(size.array() - 1);
        for (int k = low.z(); k <= high.z(); ++k) {
            for (int j = low.y(); j <= high.y(); ++j) {
                std::uint8_t* row = &mask.at(0, j, k);
                for (int i = low.x(); i <= high.x(); ++i) {
                    row[i] = std::max(row[i], betweenComponents);
                }
            }
        }
    };
    for (int k = 0; k < size.z(); ++k) {
        for (int j = 0; j < size.y(); ++j) {
            for (int i = 0; i < size.x(); ++i) {
                if (mask.at(i, j, k) == bright) {
                    markAround({i, j, k});
                }
            }
        }
    }
}

}   // namespace

void labelBrightComponents(VoxelMask& mask, double minLargeMl, const BrightLabels& marks,
                           const MetalSelector& selectMetal)
{
    for (std::uint8_t& voxel : mask.voxels) {
        voxel = voxel != 0 ? bright : 0;
    }
    markSurroundings(mask);
    const double voxelMl = mask.geometry.spacingMm.prod() / 1000.0;
    const auto minVoxels = static_cast<std::size_t>(std::ceil(minLargeMl / voxelMl));
    const auto isBright = [&mask](std::uint32_t voxel) { return mask.voxels[voxel] == bright; };
    std::vector<VoxelComponent> large = connectedComponents(mask, minVoxels);
    for (VoxelComponent& piece : large) {
        std::erase_if(piece, [&](std::uint32_t voxel) { return !isBright(voxel); });
    }
    std::erase_if(large, [&](const VoxelComponent& piece) { return piece.size() < minVoxels; });
    for (std::uint8_t& voxel : mask.voxels) {
        voxel = voxel == bright ? marks.small : std::uint8_t{0};
    }
    for (const VoxelComponent& piece : large) {
        for (const std::uint32_t voxel : piece) {
            mask.voxels[voxel] = marks.large;
        }
        for (const std::uint32_t voxel : selectMetal ? selectMetal(piece) : VoxelComponent()) {
            mask.voxels[voxel] = marks.metal;
        }
    }
}

}   // namespace angiopose::core

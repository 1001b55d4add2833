#include "core/tracing/volume/voxels/voxel_components.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr std::size_t componentProgressMask = 0x3FFF;   ///< bit mask; progress is reported every 16384 voxels

bool isStopRequested(TracingProgress* progress, std::size_t done)
{
    return progress != nullptr && (done & componentProgressMask) == 0 && !progress->advance(0.0);
}

/// Removes the component around `seed` from `remaining` and returns it.
VoxelComponent extractComponent(VoxelMask& remaining, std::size_t seed, TracingProgress* progress)
{
    const VolumeGeometry& grid = remaining.geometry;
    VoxelComponent piece{static_cast<std::uint32_t>(seed)};
    remaining.voxels[seed] = 0;
    for (std::size_t n = 0; n < piece.size() && !isStopRequested(progress, n); ++n) {
        const Eigen::Vector3i at = grid.voxelAt(piece[n]);
        const Eigen::Array3i low = (at.array() - 1).max(0);
        const Eigen::Array3i high = (at.array() + 1).min(grid.size.array() - 1);
        for (int z = low.z(); z <= high.z(); ++z) {
            for (int y = low.y(); y <= high.y(); ++y) {
                for (int x = low.x(); x <= high.x(); ++x) {
                    const std::size_t next = grid.index(x, y, z);
                    if (remaining.voxels[next] != 0) {
                        remaining.voxels[next] = 0;
                        piece.push_back(static_cast<std::uint32_t>(next));
                    }
                }
            }
        }
    }
    std::sort(piece.begin(), piece.end());
    return piece;
}

}   // namespace

std::vector<VoxelComponent> connectedComponents(const VoxelMask& mask, std::size_t minVoxels, TracingProgress* progress)
{
    VoxelMask remaining = mask;
    std::vector<VoxelComponent> pieces;
    for (std::size_t p = 0; p < remaining.voxels.size() && !isStopRequested(progress, p); ++p) {
        if (remaining.voxels[p] != 0) {
            VoxelComponent piece = extractComponent(remaining, p, progress);
            if (piece.size() >= minVoxels) {
                piece.shrink_to_fit();
                pieces.push_back(std::move(piece));
            }
        }
    }
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const VoxelComponent& a, const VoxelComponent& b) { return a.size() > b.size(); });
    return pieces;
}

VoxelBox boxOf(const VoxelMask& mask)
{
    const VolumeGeometry& grid = mask.geometry;
    VoxelBox box{grid.size, Eigen::Vector3i::Zero()};
    for (int k = 0; k < grid.size.z(); ++k) {
        for (int j = 0; j < grid.size.y(); ++j) {
            const auto row = mask.voxels.begin() + static_cast<std::ptrdiff_t>(grid.index(0, j, k));
            const auto isSet = [](std::uint8_t voxel) { return voxel != 0; };
            const auto from = std::find_if(row, row + grid.size.x(), isSet);
            if (from == row + grid.size.x()) {
                continue;
            }
            auto last = row + grid.size.x() - 1;
            while (*last == 0) {
                --last;
            }
            box.low = box.low.cwiseMin(Eigen::Vector3i(static_cast<int>(from - row), j, k));
            box.high = box.high.cwiseMax(Eigen::Vector3i(static_cast<int>(last - row) + 1, j + 1, k + 1));
        }
    }
    return box;
}

VoxelBox enlargedBox(const VoxelComponent& piece, const VolumeGeometry& grid, double aroundMm)
{
    VoxelBox box{grid.size, Eigen::Vector3i::Zero()};
    for (const std::uint32_t voxel : piece) {
        const Eigen::Vector3i at = grid.voxelAt(voxel);
        box.low = box.low.cwiseMin(at);
        box.high = box.high.cwiseMax((at.array() + 1).matrix());
    }
    const Eigen::Vector3i reach = (aroundMm / grid.spacingMm.array()).ceil().cast<int>();
    return {(box.low - reach).cwiseMax(0), (box.high + reach).cwiseMin(grid.size)};
}

}   // namespace angiopose::core

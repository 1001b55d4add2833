#include "core/tracing/volume/voxels/beyond_rim.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace angiopose::core {
namespace {

constexpr double longestCut = 2.5;   ///< maximum length over width of a cut across a vessel
constexpr int maxLayers = 60;

/// One side of the grid: the plane at `position` across `axis`; `outwards` is -1 or +1.
struct Face {
    int axis = 0;
    int position = 0;
    int outwards = 1;
};

/// Intersection of the lumen with a face, and the number of layers added beyond it.
struct Cut {
    Face face;
    std::vector<Eigen::Vector3i> voxels;
    int layers = 0;
};

/// Number of layers for a cut: as many as its radius if it is round, none if it is elongated.
int layersOf(const std::vector<Eigen::Vector3i>& voxels, int axis)
{
    Eigen::Vector3i low = voxels.front();
    Eigen::Vector3i high = voxels.front();
    for (const Eigen::Vector3i& voxel : voxels) {
        low = low.cwiseMin(voxel);
        high = high.cwiseMax(voxel);
    }
    const Eigen::Vector3i extent = (high - low).array() + 1;
    const int a = extent[(axis + 1) % 3];
    const int b = extent[(axis + 2) % 3];
    if (std::max(a, b) > longestCut * std::min(a, b)) {
        return 0;
    }
    const double radius = std::sqrt(static_cast<double>(voxels.size()) / std::numbers::pi);
    return std::min(maxLayers, static_cast<int>(std::ceil(1.2 * radius)) + 1);
}

/// Finds the connected cuts in one face.
void findCuts(const VoxelMask& mask, const Face& face, std::vector<Cut>& cuts)
{
    const Eigen::Vector3i& size = mask.geometry.size;
    const int u = (face.axis + 1) % 3;
    const int v = (face.axis + 2) % 3;
    std::vector<std::uint8_t> seen(static_cast<std::size_t>(size[u]) * static_cast<std::size_t>(size[v]), 0);
    const auto voxelAt = [&](int a, int b) {
        Eigen::Vector3i voxel;
        voxel[face.axis] = face.position;
        voxel[u] = a;
        voxel[v] = b;
        return voxel;
    };
    const auto take = [&](int a, int b) {
        if (a < 0 || b < 0 || a >= size[u] || b >= size[v]) {
            return false;
        }
        std::uint8_t& isSeen =
            seen[static_cast<std::size_t>(b) * static_cast<std::size_t>(size[u]) + static_cast<std::size_t>(a)];
        const Eigen::Vector3i voxel = voxelAt(a, b);
        const bool isNew = isSeen == 0 && mask.at(voxel.x(), voxel.y(), voxel.z()) != 0;
        isSeen = 1;
        return isNew;
    };
    for (int b = 0; b < size[v]; ++b) {
        for (int a = 0; a < size[u]; ++a) {
            if (!take(a, b)) {
                continue;
            }
            Cut cut{face, {voxelAt(a, b)}, 0};
            for (std::size_t n = 0; n < cut.voxels.size(); ++n) {
                const Eigen::Vector3i at = cut.voxels[n];
                for (const auto& [da, db] : std::array<std::array<int, 2>, 4>{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}}) {
                    if (take(at[u] + da, at[v] + db)) {
                        cut.voxels.push_back(voxelAt(at[u] + da, at[v] + db));
                    }
                }
            }
            cut.layers = layersOf(cut.voxels, face.axis);
            cuts.push_back(std::move(cut));
        }
    }
}

}   // namespace

WiderMask continuedBeyondRim(const VoxelMask& mask)
{
    const Eigen::Vector3i& size = mask.geometry.size;
    std::vector<Cut> cuts;
    for (int axis = 0; axis < 3; ++axis) {
        findCuts(mask, {axis, 0, -1}, cuts);
        findCuts(mask, {axis, size[axis] - 1, 1}, cuts);
    }
    WiderMask wider;
    Eigen::Vector3i after = Eigen::Vector3i::Ones();
    for (const Cut& cut : cuts) {
        int& room = cut.face.outwards < 0 ? wider.offset[cut.face.axis] : after[cut.face.axis];
        room = std::max(room, cut.layers + 1);
    }
    VolumeGeometry grid;
    grid.size = size + wider.offset + after;
    wider.mask = VoxelMask(grid);
    for (int k = 0; k < size.z(); ++k) {
        for (int j = 0; j < size.y(); ++j) {
            const Eigen::Vector3i to = Eigen::Vector3i(0, j, k) + wider.offset;
            std::copy_n(&mask.at(0, j, k), size.x(), &wider.mask.at(to.x(), to.y(), to.z()));
        }
    }
    for (const Cut& cut : cuts) {
        for (const Eigen::Vector3i& voxel : cut.voxels) {
            for (int layer = 1; layer <= cut.layers; ++layer) {
                Eigen::Vector3i to = voxel + wider.offset;
                to[cut.face.axis] += layer * cut.face.outwards;
                wider.mask.at(to.x(), to.y(), to.z()) = 1;
            }
        }
    }
    return wider;
}

}   // namespace angiopose::core
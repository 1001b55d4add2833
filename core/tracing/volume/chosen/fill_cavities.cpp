#include "core/tracing/volume/chosen/fill_cavities.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr std::uint8_t enclosed = 0;   ///< assumed until an outside neighbor is found
constexpr std::uint8_t inside = 1;
constexpr std::uint8_t outside = 2;
constexpr std::uint8_t filled = 2;
constexpr int minSetNeighbors = 17;   ///< minimum, out of 26 neighbors; a flat wall has 9, an obtuse corner has 15

/// Makes one pass over the rows, upward (`step` = 1) or downward (-1): marks voxels as outside if the preceding
/// neighbor along any axis is outside.
bool sweep(VoxelMask& mask, int step, TracingProgress* progress)
{
    const Eigen::Vector3i& size = mask.geometry.size;
    const auto first = [step](int count) { return step > 0 ? 0 : count - 1; };
    const auto isWithin = [](int at, int count) { return at >= 0 && at < count; };
    const auto strideY = static_cast<std::ptrdiff_t>(size.x());
    const auto strideZ = strideY * size.y();
    bool changed = false;
    for (int k = first(size.z()); isWithin(k, size.z()); k += step) {
        if (progress != nullptr && !progress->advance(0.0)) {
            return false;
        }
        for (int j = first(size.y()); isWithin(j, size.y()); j += step) {
            std::uint8_t* row = &mask.at(0, j, k);
            const bool isRimRow = !isWithin(j - step, size.y()) || !isWithin(k - step, size.z());
            const std::uint8_t* behind = isRimRow ? nullptr : row - step * strideY;
            const std::uint8_t* below = isRimRow ? nullptr : row - step * strideZ;
            bool isOutside = true;   // state before the first voxel of the row
            for (int i = first(size.x()); isWithin(i, size.x()); i += step) {
                if (row[i] == enclosed && (isOutside || isRimRow || behind[i] == outside || below[i] == outside)) {
                    row[i] = outside;
                    changed = true;
                }
                isOutside = row[i] == outside;
            }
        }
    }
    return changed;
}

}   // namespace

void fillCavities(VoxelMask& mask, TracingProgress* progress)
{
    if (mask.voxels.empty()) {
        return;
    }
    for (std::uint8_t& voxel : mask.voxels) {
        voxel = voxel != 0 ? inside : enclosed;
    }
    for (bool changed = true; changed;) {
        changed = sweep(mask, 1, progress);
        changed = sweep(mask, -1, progress) || changed;
    }
    for (std::uint8_t& voxel : mask.voxels) {
        voxel = voxel == outside ? std::uint8_t{0} : voxel == inside ? inside : filled;
    }
}

void fillHoles(VoxelMask& mask, const HoleFilter& isHole)
{
    const Eigen::Vector3i& size = mask.geometry.size;
    const auto strideY = static_cast<std::ptrdiff_t>(size.x());
    const auto strideZ = strideY * size.y();
    std::vector<std::size_t> found;
    for (int k = 1; k + 1 < size.z(); ++k) {
        for (int j = 1; j + 1 < size.y(); ++j) {
            for (int i = 1; i + 1 < size.x(); ++i) {
                const std::uint8_t* voxel = &mask.at(i, j, k);
                if (*voxel != 0 || (voxel[-1] == 0 && voxel[1] == 0)) {
                    continue;
                }
                int set = 0;
                for (std::ptrdiff_t z = -strideZ; z <= strideZ; z += strideZ) {
                    for (std::ptrdiff_t y = -strideY; y <= strideY; y += strideY) {
                        for (std::ptrdiff_t x = -1; x <= 1; ++x) {
                            set += voxel[z + y + x] != 0 ? 1 : 0;
                        }
                    }
                }
                if (set >= minSetNeighbors && (!isHole || isHole(i, j, k))) {
                    found.push_back(mask.geometry.index(i, j, k));
                }
            }
        }
    }
    for (const std::size_t voxel : found) {
        mask.voxels[voxel] = filled;
    }
}

}   // namespace angiopose::core

#include "core/imaging/mask_cut.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

/// Returns for every pixel of a slice whether its center lies inside an outline, by the even-odd rule.
std::vector<std::uint8_t> fillOutline(const SliceGrid& slice, const std::vector<Eigen::Vector2d>& outline)
{
    std::vector<std::uint8_t> inside(static_cast<std::size_t>(slice.width) * static_cast<std::size_t>(slice.height));
    std::vector<double> crossings;
    for (int row = 0; row < slice.height; ++row) {
        crossings.clear();
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Eigen::Vector2d& a = outline[i];
            const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
            if ((a.y() <= row) != (b.y() <= row)) {
                crossings.push_back(a.x() + (row - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
            }
        }
        std::ranges::sort(crossings);
        for (std::size_t c = 0; c + 1 < crossings.size(); c += 2) {
            const int first = std::max(0, static_cast<int>(std::ceil(crossings[c])));
            const int last = std::min(slice.width - 1, static_cast<int>(std::floor(crossings[c + 1])));
            for (int column = first; column <= last; ++column) {
                inside[static_cast<std::size_t>(row) * static_cast<std::size_t>(slice.width) +
                       static_cast<std::size_t>(column)] = 1;
            }
        }
    }
    return inside;
}

/// Classifies pixels of the slice as inside or outside the outline; pixels beyond the slice count as outside.
class OutlineMask {
public:
    OutlineMask(const MaskCut& cut) : slice_(cut.slice), inside_(fillOutline(cut.slice, cut.outline)) {}
    CutSide at(int column, int row) const
    {
        const bool isThere = column >= 0 && row >= 0 && column < slice_.width && row < slice_.height;
        const auto pixel =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(slice_.width) + static_cast<std::size_t>(column);
        return isThere && inside_[pixel] != 0 ? CutSide::Inside : CutSide::Outside;
    }

private:
    const SliceGrid& slice_;
    std::vector<std::uint8_t> inside_;
};

/// Returns the voxels to remove that are displayed in a pixel of the slice.
VoxelIndices cutInPixels(const VoxelMask& mask, const MaskCut& cut, const OutlineMask& sides)
{
    const Eigen::Affine3d voxelFromPatient = mask.geometry.patientFromVoxel().inverse();
    VoxelIndices found;
    for (int row = 0; row < cut.slice.height; ++row) {
        for (int column = 0; column < cut.slice.width; ++column) {
            const Eigen::Vector3d point = cut.slice.pointAt({column, row});
            const Eigen::Vector3i voxel = (voxelFromPatient * point).array().round().cast<int>();
            if (sides.at(column, row) == cut.side && mask.geometry.contains(voxel)) {
                const std::uint32_t place = voxelIndex(mask.geometry, voxel);
                if (mask.voxels[place] != 0) {
                    found.push_back(place);
                }
            }
        }
    }
    return found;
}

VoxelIndices cutInDepth(const VoxelMask& mask, const MaskCut& cut, const OutlineMask& sides, double halfDepthMm)
{
    const Eigen::Affine3d patientFromVoxel = mask.geometry.patientFromVoxel();
    VoxelIndices found;
    for (std::size_t place = 0; place < mask.voxels.size(); ++place) {
        if (mask.voxels[place] == 0) {
            continue;
        }
        const Eigen::Vector3d point = patientFromVoxel * mask.geometry.voxelAt(place).cast<double>();
        const Eigen::Vector2d pixel = cut.slice.pixelOf(point);
        if (std::abs(cut.slice.distanceMm(point)) <= halfDepthMm &&
            sides.at(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y()))) == cut.side) {
            found.push_back(static_cast<std::uint32_t>(place));
        }
    }
    return found;
}

/// Combines both searches: a mask finer than the slice has voxels between the pixels, and a coarser mask has displayed
/// voxels whose centers lie outside the slice.
VoxelIndices cutInSlice(const VoxelMask& mask, const MaskCut& cut, const OutlineMask& sides)
{
    VoxelIndices found = cutInPixels(mask, cut, sides);
    const VoxelIndices between = cutInDepth(mask, cut, sides, halfThicknessMm(cut.slice));
    found.insert(found.end(), between.begin(), between.end());
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

}   // namespace

VoxelIndices cutVoxels(const VoxelMask& mask, const MaskCut& cut)
{
    const OutlineMask sides(cut);
    return cut.halfDepthMm > 0.0 ? cutInDepth(mask, cut, sides, cut.halfDepthMm) : cutInSlice(mask, cut, sides);
}

}   // namespace angiopose::core

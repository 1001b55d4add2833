#include "core/tracing/volume/stents/stent_site.h"

namespace angiopose::core {
namespace {

VoxelBox boxAroundAll(const std::vector<VoxelComponent>& pieces, const VolumeGeometry& grid, double aroundMm)
{
    VoxelBox all{grid.size, Eigen::Vector3i::Zero()};
    for (const VoxelComponent& piece : pieces) {
        const VoxelBox box = enlargedBox(piece, grid, aroundMm);
        all = {all.low.cwiseMin(box.low), all.high.cwiseMax(box.high)};
    }
    return all;
}

}   // namespace

StentSite::StentSite(const VoxelMask& lumen, const StentStruts& wires, const VoxelOpacification& opacification,
                     double aroundMm)
    : lumen_(lumen),
      stents_(wires),
      opacification_(opacification),
      box_(boxAroundAll(wires.pieces, lumen.geometry, aroundMm)),
      wires_(crop(lumen.geometry, box_))
{
    labels = VoxelGrid<Label>(wires_.geometry);
    for (const VoxelComponent& piece : wires.pieces) {
        for (const std::uint32_t voxel : piece) {
            const Eigen::Vector3i at = lumen.geometry.voxelAt(voxel) - box_.low;
            wires_.at(at.x(), at.y(), at.z()) = 1;
        }
    }
}

std::uint32_t StentSite::scanIndex(const Eigen::Vector3i& at) const
{
    const Eigen::Vector3i whole = at + box_.low;
    return static_cast<std::uint32_t>(lumen_.geometry.index(whole.x(), whole.y(), whole.z()));
}

std::uint8_t StentSite::lumenAt(const Eigen::Vector3i& at) const
{
    return lumen_.voxels[scanIndex(at)];
}

double StentSite::fillAt(const Eigen::Vector3i& at) const
{
    return opacification_(at.x() + box_.low.x(), at.y() + box_.low.y(), at.z() + box_.low.z());
}

bool StentSite::isBesideStruts(const Eigen::Vector3i& at) const
{
    return stents_.isBeside(at.x() + box_.low.x(), at.y() + box_.low.y(), at.z() + box_.low.z());
}

StentSite::OpacificationSamples StentSite::collectOpacification(Label label, const VoxelBox& within) const
{
    OpacificationSamples fills;
    const Eigen::Vector3i low = within.low.cwiseMax(0);
    const Eigen::Vector3i high = within.high.cwiseMin((geometry().size.array() - 1).matrix());
    for (int k = low.z(); k <= high.z(); ++k) {
        for (int j = low.y(); j <= high.y(); ++j) {
            for (int i = low.x(); i <= high.x(); ++i) {
                const Eigen::Vector3i at(i, j, k);
                if (labelAt(at) != label || isStrut(at)) {
                    continue;
                }
                fills.all.push_back(fillAt(at));
                if (lumenAt(at) > 1) {
                    fills.inner.push_back(fills.all.back());
                }
            }
        }
    }
    return fills;
}

}   // namespace angiopose::core

#include "core/imaging/mask_edit.h"

#include <algorithm>
#include <limits>

namespace angiopose::core {

bool isSameGrid(const VolumeGeometry& a, const VolumeGeometry& b)
{
    return a.size == b.size && a.originInPatient == b.originInPatient && a.spacingMm == b.spacingMm &&
           a.direction == b.direction;
}

std::size_t MaskChange::voxelCount() const
{
    std::size_t count = 0;
    for (const Run& run : runs) {
        count += run.count;
    }
    return count;
}

MaskChange makeMaskChange(VoxelIndices voxels)
{
    std::ranges::sort(voxels);
    voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
    MaskChange change;
    for (const std::uint32_t voxel : voxels) {
        if (!change.runs.empty() && change.runs.back().first + change.runs.back().count == voxel) {
            ++change.runs.back().count;
        } else {
            change.runs.push_back({voxel, 1});
        }
    }
    return change;
}

void flip(VoxelMask& mask, const MaskChange& change)
{
    for (const MaskChange::Run& run : change.runs) {
        const auto first = mask.voxels.begin() + run.first;
        std::transform(first, first + run.count, first,
                       [](std::uint8_t voxel) { return static_cast<std::uint8_t>(voxel == 0 ? 1 : 0); });
    }
}

BoundingBox boxOf(const VolumeGeometry& geometry, const MaskChange& change)
{
    Eigen::Vector3i low = Eigen::Vector3i::Constant(std::numeric_limits<int>::max());
    Eigen::Vector3i high = Eigen::Vector3i::Constant(-1);
    for (const MaskChange::Run& run : change.runs) {
        const Eigen::Vector3i first = geometry.voxelAt(run.first);
        const Eigen::Vector3i last = geometry.voxelAt(run.first + run.count - 1);
        low = low.cwiseMin(first).cwiseMin(last);
        high = high.cwiseMax(first).cwiseMax(last);
        if (first.y() != last.y() || first.z() != last.z()) {   // the run continues in the next row
            low.x() = 0;
            high.x() = geometry.size.x() - 1;
        }
        if (first.z() != last.z()) {
            low.y() = 0;
            high.y() = geometry.size.y() - 1;
        }
    }
    BoundingBox box{Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()),
                    Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity())};
    const Eigen::Affine3d patientFromVoxel = geometry.patientFromVoxel();
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d at((corner & 1) != 0 ? high.x() + 0.5 : low.x() - 0.5,
                                 (corner & 2) != 0 ? high.y() + 0.5 : low.y() - 0.5,
                                 (corner & 4) != 0 ? high.z() + 0.5 : low.z() - 0.5);
        const Eigen::Vector3d point = patientFromVoxel * at;
        box.lowInPatient = box.lowInPatient.cwiseMin(point);
        box.highInPatient = box.highInPatient.cwiseMax(point);
    }
    return box;
}

}   // namespace angiopose::core

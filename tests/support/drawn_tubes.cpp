#include "tests/support/drawn_tubes.h"
#include "tests/support/for_each.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::test {

core::VolumeGeometry gridAround(const Eigen::Vector3d& centerMm, const Eigen::Vector3i& size,
                                const Eigen::Vector3d& spacingMm)
{
    core::VolumeGeometry grid;
    grid.size = size;
    grid.spacingMm = spacingMm;
    grid.originInPatient = centerMm - 0.5 * spacingMm.cwiseProduct((size.array() - 1).cast<double>().matrix());
    return grid;
}

core::VolumeGeometry restored(const core::VolumeGeometry& grid, const std::array<int, 3>& order,
                              const std::array<bool, 3>& flipped)
{
    core::VolumeGeometry result;
    Eigen::Vector3d corner = Eigen::Vector3d::Zero();
    for (int a = 0; a < 3; ++a) {
        const int from = order[static_cast<std::size_t>(a)];
        const bool isFlipped = flipped[static_cast<std::size_t>(a)];
        result.size[a] = grid.size[from];
        result.spacingMm[a] = grid.spacingMm[from];
        result.direction.col(a) = (isFlipped ? -1.0 : 1.0) * grid.direction.col(from);
        corner[from] = isFlipped ? grid.size[from] - 1 : 0;
    }
    result.originInPatient = grid.patientFromVoxel() * corner;
    return result;
}

double distanceToWall(const std::vector<Tube>& tubes, const Eigen::Vector3d& pointMm)
{
    double nearest = std::numeric_limits<double>::max();
    for (const Tube& tube : tubes) {
        const Eigen::Vector3d axis = tube.toMm - tube.fromMm;
        const double share = std::clamp((pointMm - tube.fromMm).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
        const double endRadius = tube.endRadiusMm > 0.0 ? tube.endRadiusMm : tube.radiusMm;
        const double radius = tube.radiusMm + share * (endRadius - tube.radiusMm);
        nearest = std::min(nearest, (pointMm - tube.fromMm - share * axis).norm() - radius);
    }
    return nearest;
}

core::VoxelMask drawnMask(const core::VolumeGeometry& grid, const std::vector<Tube>& tubes)
{
    core::VoxelMask mask(grid);
    const Eigen::Affine3d patientFromVoxel = grid.patientFromVoxel();
    test::forEachVoxel(grid.size, [&](int i, int j, int k) {
        const Eigen::Vector3d point = patientFromVoxel * Eigen::Vector3d(i, j, k);
        mask.at(i, j, k) = distanceToWall(tubes, point) <= 0.0 ? 1 : 0;
    });
    return mask;
}

core::Volume tubesInTissue(const core::VolumeGeometry& grid, const std::vector<Tube>& tubes)
{
    core::Volume volume(grid);
    std::size_t voxel = 0;
    for (int k = 0; k < grid.size.z(); ++k) {
        for (int j = 0; j < grid.size.y(); ++j) {
            for (int i = 0; i < grid.size.x(); ++i, ++voxel) {
                const double wall = distanceToWall(tubes, grid.patientFromVoxel() * Eigen::Vector3d(i, j, k));
                const double share = std::clamp(0.5 - wall, 0.0, 1.0);
                const bool isAir = i < 3;
                volume.voxels[voxel] = static_cast<std::int16_t>(isAir ? -1000 : std::lround(50 + 350 * share));
            }
        }
    }
    return volume;
}

}   // namespace angiopose::test

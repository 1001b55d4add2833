#pragma once

#include "core/imaging/volume.h"

#include <Eigen/Core>

namespace angiopose::core {

/// Interpolates linearly between the eight voxels around a point; the outermost voxels are replicated beyond the grid.
/// `pointMm` is the position along the grid axes in mm, from the first voxel; `valueAt(Eigen::Vector3i)` returns a
/// voxel's value.
template <class ValueAt>
double interpolateTrilinear(const VolumeGeometry& grid, const Eigen::Vector3d& pointMm, const ValueAt& valueAt)
{
    const Eigen::Vector3d voxel = pointMm.cwiseQuotient(grid.spacingMm);
    const Eigen::Vector3d low = voxel.array().floor();
    const Eigen::Vector3d share = voxel - low;
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3i step(corner & 1, corner >> 1 & 1, corner >> 2);
        const Eigen::Vector3i at = (low.cast<int>() + step).cwiseMax(0).cwiseMin((grid.size.array() - 1).matrix());
        const Eigen::Vector3d weight = (step.array() != 0).select(share.array(), 1.0 - share.array());
        sum += weight.prod() * valueAt(at);
    }
    return sum;
}

}   // namespace angiopose::core

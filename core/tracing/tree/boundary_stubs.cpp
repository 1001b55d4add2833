#include "core/tracing/tree/boundary_stubs.h"

#include "core/support/quantile.h"
#include "core/vessel/polyline.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace angiopose::core {
namespace {

constexpr double boundaryVoxels = 2.0;
constexpr double minInRadii = 1.5;

/// Returns whether an end is close to a face of the grid at a point where the lumen touches that face.
bool isCutByBoundary(const Eigen::Vector3d& endMm, const VoxelMask& lumen)
{
    const VolumeGeometry& grid = lumen.geometry;
    const Eigen::Array3d at = endMm.cwiseQuotient(grid.spacingMm).array();
    const Eigen::Array3d last = grid.size.cast<double>().array() - 1.0;
    const Eigen::Vector3i voxel = at.round().max(0.0).min(last).cast<int>();
    for (int axis = 0; axis < 3; ++axis) {
        for (const double face : {0.0, last[axis]}) {
            Eigen::Vector3i onFace = voxel;
            onFace[axis] = static_cast<int>(face);
            if (std::abs(at[axis] - face) <= boundaryVoxels && lumen.at(onFace.x(), onFace.y(), onFace.z()) != 0) {
                return true;
            }
        }
    }
    return false;
}

/// Returns whether a point lies outside the wall of the nearest part of `parent`.
bool isOutside(const Eigen::Vector3d& pointMm, const VesselCurve& parent)
{
    double nearestSquared = std::numeric_limits<double>::max();
    double radiusMm = 0.0;
    for (std::size_t n = 0; n < parent.pointsMm.size(); ++n) {
        const double squared = (parent.pointsMm[n] - pointMm).squaredNorm();
        if (squared < nearestSquared) {
            nearestSquared = squared;
            radiusMm = parent.radiusMm[n];
        }
    }
    return nearestSquared > radiusMm * radiusMm;
}

}   // namespace

bool isBoundaryStub(const VesselCurve& curve, const VesselCurve& parent, const VoxelMask& lumen, double minMm)
{
    if (!isCutByBoundary(curve.pointsMm.back(), lumen)) {
        return false;
    }
    double outsideMm = 0.0;
    std::vector<double> radii;
    for (std::size_t n = 1; n < curve.pointsMm.size(); ++n) {
        if (isOutside(curve.pointsMm[n], parent)) {
            outsideMm += (curve.pointsMm[n] - curve.pointsMm[n - 1]).norm();
            radii.push_back(curve.radiusMm[n]);
        }
    }
    return radii.empty() || outsideMm < std::max(minMm, minInRadii * medianOf(std::move(radii)));
}

bool isBoundaryFragment(const VesselCurve& curve, const VoxelMask& lumen, double minMm)
{
    return polylineLength<3>(curve.pointsMm) < minMm && isCutByBoundary(curve.pointsMm.front(), lumen) &&
           isCutByBoundary(curve.pointsMm.back(), lumen);
}

}   // namespace angiopose::core

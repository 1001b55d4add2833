#pragma once

#include "core/imaging/volume.h"
#include "core/support/random.h"
#include "core/vessel/vessel_tree.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace angiopose::core {

using ScanGrid = VoxelGrid<float>;   ///< simulated scan in HU, with axes parallel to the patient's axes

/// Returns the fraction of a voxel that lies inside a wall at `distanceMm` (negative inside the wall).
inline double fractionInside(double distanceMm, double voxelMm)
{
    return std::clamp(0.5 - distanceMm / voxelMm, 0.0, 1.0);
}

/// Draws shapes, given by their distance functions, into the voxel grid with partial volume.
class ScanPainter {
public:
    explicit ScanPainter(ScanGrid& grid) : grid_(grid), voxelMm_(std::cbrt(grid.geometry.spacingMm.prod())) {}

    /// Calls `work(voxel index, point)` for each voxel in the box of half size `reachMm` around `center`.
    template <class Work>
    void forEachVoxelAround(const Eigen::Vector3d& center, const Eigen::Vector3d& reachMm, const Work& work)
    {
        const VolumeGeometry& geometry = grid_.geometry;
        const Eigen::Array3d middle = (center - geometry.originInPatient).cwiseQuotient(geometry.spacingMm);
        const Eigen::Array3d reach = reachMm.cwiseQuotient(geometry.spacingMm).array() + 1.0;
        const Eigen::Array3i low = (middle - reach).floor().max(0.0).cast<int>();
        const Eigen::Array3i high = (middle + reach).ceil().min(geometry.size.cast<double>().array() - 1.0).cast<int>();
        for (int k = low.z(); k <= high.z(); ++k) {
            for (int j = low.y(); j <= high.y(); ++j) {
                for (int i = low.x(); i <= high.x(); ++i) {
                    work(geometry.index(i, j, k),
                         geometry.originInPatient + geometry.spacingMm.cwiseProduct(Eigen::Vector3d(i, j, k)));
                }
            }
        }
    }

    void blend(std::size_t voxel, double share, double hu)
    {
        grid_.voxels[voxel] += static_cast<float>(share * (hu - grid_.voxels[voxel]));
    }

    /// Draws an ellipsoid; an infinite half-axis makes it a cylinder.
    void ellipsoid(const Eigen::Vector3d& center, const Eigen::Vector3d& halfAxes, double hu)
    {
        ellipsoid(center, halfAxes, [hu] { return hu; });
    }

    /// Draws an ellipsoid with the value that `draw()` returns for each voxel.
    template <class Draw>
    requires std::is_invocable_r_v<double, Draw>
    void ellipsoid(const Eigen::Vector3d& center, const Eigen::Vector3d& halfAxes, const Draw& draw)
    {
        const double smallest = halfAxes.minCoeff();
        forEachVoxelAround(center, halfAxes.cwiseMin(1e5), [&](std::size_t voxel, const Eigen::Vector3d& point) {
            const double radius = (point - center).cwiseQuotient(halfAxes).norm();
            if (const double share = fractionInside((radius - 1.0) * smallest, voxelMm_); share > 0.0) {
                blend(voxel, share, draw());
            }
        });
    }

    double voxelMm() const { return voxelMm_; }
    const VolumeGeometry& geometry() const { return grid_.geometry; }

private:
    ScanGrid& grid_;
    double voxelMm_;
};

/// Returns a grid of this size centered on the origin of the patient frame.
VolumeGeometry gridAroundOrigin(const Eigen::Vector3i& size, const Eigen::Vector3d& spacingMm);

/// Draws the lumen of the vessels with the value `hu`.
void paintTree(ScanPainter& painter, const VesselTree& tree, const VolumeGeometry& geometry, double hu);

/// Applies a Gaussian blur along each axis in turn, with border values replicated.
void blurScan(ScanGrid& grid, double sigmaVoxels);

/// Rounds `value(voxel of the grid, generator)` to an integer for each voxel, with one random generator per slice.
template <class Value>
Volume roundVolume(const ScanGrid& grid, const CounterRandom& random, const Value& value)
{
    Volume volume(grid.geometry);
    const auto sliceVoxels =
        static_cast<std::size_t>(grid.geometry.size.x()) * static_cast<std::size_t>(grid.geometry.size.y());
    for (int k = 0; k < grid.geometry.size.z(); ++k) {
        CounterRandom sliceRandom = random.fork(static_cast<std::uint64_t>(k));
        for (std::size_t n = 0; n < sliceVoxels; ++n) {
            const std::size_t voxel = static_cast<std::size_t>(k) * sliceVoxels + n;
            volume.voxels[voxel] = static_cast<std::int16_t>(std::lround(value(grid.voxels[voxel], sliceRandom)));
        }
    }
    return volume;
}

/// Returns the scan as stored values, with noise added.
Volume storedVolume(const ScanGrid& grid, double noiseHu, const CounterRandom& random);

}   // namespace angiopose::core

#include "core/tracing/tree/skeleton_coverage.h"

#include "core/tracing/volume/voxels/component_selection.h"
#include "core/tracing/volume/voxels/voxel_components.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double coverDistanceVoxels = 2.0;
constexpr double stepOfCurve = 0.5;   ///< sampling distance, relative to the smallest voxel side

/// Clears the voxels near `at` (in voxel coordinates).
void clearAround(VoxelMask& missed, const Eigen::Vector3d& at)
{
    const VolumeGeometry& grid = missed.geometry;
    const Eigen::Vector3i low = (at.array() - coverDistanceVoxels).ceil().max(0.0).cast<int>();
    const Eigen::Vector3i high =
        (at.array() + coverDistanceVoxels).floor().min(grid.size.cast<double>().array() - 1.0).cast<int>();
    for (int k = low.z(); k <= high.z(); ++k) {
        for (int j = low.y(); j <= high.y(); ++j) {
            for (int i = low.x(); i <= high.x(); ++i) {
                if ((Eigen::Vector3d(i, j, k) - at).squaredNorm() <= coverDistanceVoxels * coverDistanceVoxels) {
                    missed.at(i, j, k) = 0;
                }
            }
        }
    }
}

}   // namespace

SkeletonCoverage measureCoverage(const VolumeGeometry& grid, const std::vector<std::size_t>& skeleton,
                                 const VesselTree& tree)
{
    VoxelMask missed(grid);
    for (const std::size_t voxel : skeleton) {
        missed.voxels[voxel] = 1;
    }
    const Eigen::Affine3d voxelFromPatient = grid.patientFromVoxel().inverse();
    for (const VesselBranch& branch : resampled(tree, stepOfCurve * grid.spacingMm.minCoeff()).branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            clearAround(missed, voxelFromPatient * point);
        }
    }
    VoxelMask whole(grid);
    for (const std::size_t voxel : skeleton) {
        whole.voxels[voxel] = 1;
    }
    std::size_t all = 0;
    std::size_t missedTotal = 0;
    for (const VoxelComponent& component : connectedComponents(whole)) {
        const auto missedCount = static_cast<std::size_t>(
            std::ranges::count_if(component, [&](std::uint32_t voxel) { return missed.voxels[voxel] != 0; }));
        const bool isTraced = missedCount < component.size();
        for (const std::uint32_t voxel : component) {   // components without any branch are reported elsewhere
            missed.voxels[voxel] = isTraced ? missed.voxels[voxel] : std::uint8_t{0};
        }
        all += isTraced ? component.size() : 0;
        missedTotal += isTraced ? missedCount : 0;
    }
    SkeletonCoverage cover;
    if (missedTotal > 0) {
        cover.fraction = 1.0 - static_cast<double>(missedTotal) / static_cast<double>(all);
        cover.missedInPatient = describeComponent(connectedComponents(missed).front(), grid).positionInPatient;
    }
    return cover;
}

}   // namespace angiopose::core

#include "core/tracing/volume/path/trace_tubes.h"

#include "core/imaging/mark_ball.h"
#include "core/messages/messages.h"
#include "core/support/quantile.h"
#include "core/tracing/tree/tree_from_paths.h"
#include "core/tracing/volume/chosen/selected_lumen.h"
#include "core/tracing/volume/path/appearance_along_path.h"
#include "core/tracing/volume/path/path_end.h"
#include "core/tracing/volume/path/tube_growth.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double maxWidening = 1.4;   // maximum width relative to the parent vessel
constexpr double radiusNoiseMm = 0.3;

/// Returns the mask of the voxels inside the branches, in the scan's axis order.
VoxelMask lumenOf(const VesselTree& tree, const VolumeGeometry& grid)
{
    VoxelMask lumen(grid);
    for (const VesselBranch& branch : resampled(tree, 0.5 * grid.spacingMm.minCoeff()).branches) {
        for (std::size_t n = 0; n < branch.pointsInPatient.size(); ++n) {
            markBall(branch.pointsInPatient[n], branch.radiusMm[n], lumen);
        }
    }
    return lumen;
}

/// Returns whether a branch is wider than its parent at the takeoff; such a branch is a vein that touches an artery.
bool widens(const VesselBranch& branch, const VesselBranch& parent)
{
    const Eigen::Vector3d& start = branch.pointsInPatient.front();
    std::size_t nearest = 0;
    for (std::size_t n = 1; n < parent.pointsInPatient.size(); ++n) {
        const bool isNearer =
            (parent.pointsInPatient[n] - start).norm() < (parent.pointsInPatient[nearest] - start).norm();
        nearest = isNearer ? n : nearest;
    }
    return medianOf(branch.radiusMm) > maxWidening * parent.radiusMm[nearest] + radiusNoiseMm;
}

/// Removes branches wider than their parent, and their descendants; `paths` and branches have the same order.
VesselTree removeWideningBranches(const VesselTree& tree, const std::vector<BranchPath>& paths)
{
    VesselTree kept;
    std::vector<bool> isKept(paths.size(), true);
    for (std::size_t n = 0; n < paths.size(); ++n) {
        if (paths[n].parent >= 0) {
            const auto parent = static_cast<std::size_t>(paths[n].parent);
            isKept[n] = isKept[parent] && !widens(tree.branches[n], tree.branches[parent]);
        }
        if (isKept[n]) {
            kept.branches.push_back(tree.branches[n]);
            kept.branches.back().id = static_cast<int>(kept.branches.size());
        }
    }
    return kept;
}

Result<std::vector<Eigen::Vector3i>> seedVoxels(const TubeDetector& detector, const VesselTracingOptions& options)
{
    if (options.seedsInPatient.empty()) {
        return Error(messages::tubesNeedSeed());
    }
    std::vector<Eigen::Vector3i> voxels;
    for (const Eigen::Vector3d& seed : options.seedsInPatient) {
        const auto end = findPathEnd(detector, seed);
        if (!end) {
            return end.error();
        }
        voxels.push_back(end.value().voxel);
    }
    return voxels;
}

}   // namespace

Result<TracedVessels> traceTubes(const Volume& volume, const VesselTracingOptions& options,
                                 const TracingObserver& observe)
{
    TracingProgress progress(observe);
    progress.enter("vessels", 0.0, 0.8);
    const TubeDetector detector(volume, maxTubeRadiusMm);
    const auto seeds = seedVoxels(detector, options);
    if (!seeds) {
        return seeds.error();
    }
    const TubePaths grown =
        growTubes(detector, seeds.value(), {.minBranchLengthMm = options.minBranchLengthMm}, progress);
    if (progress.isStopped()) {
        return tracingCanceled();
    }
    if (grown.paths.empty()) {
        return Error(messages::noTubeAtSeed());
    }
    const VolumeGeometry& grid = volume.geometry;
    const PathOpacification opacificationAlong = [&detector](const BranchPath& path) {
        return AppearanceAlongPath(detector, path.pointsMm).cachedOpacification();
    };
    progress.enter("branches", 0.8, 1.0);
    TracedVessels traced;
    const VesselTree unpruned = treeFromPaths(grown.paths, opacificationAlong, grid, options.pointSpacingMm, progress);
    if (progress.isStopped()) {
        return tracingCanceled();
    }
    traced.tree = removeWideningBranches(unpruned, grown.paths);
    traced.lumen = lumenOf(traced.tree, grid);
    traced.threshold = 0.5 * (grown.appearance.blood + grown.appearance.tissue);
    if (grown.isTruncated) {
        traced.warnings.push_back(messages::tubesTruncated());
    }
    return traced;
}

}   // namespace angiopose::core

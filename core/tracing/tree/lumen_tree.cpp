#include "core/tracing/tree/lumen_tree.h"

#include "core/imaging/interpolate_grid.h"
#include "core/support/parallel_for.h"
#include "core/tracing/tree/branch_paths.h"
#include "core/tracing/tree/drop_dim_parts.h"
#include "core/tracing/tree/open_loops.h"
#include "core/tracing/tree/prune_spurs.h"
#include "core/tracing/tree/vessel_curve.h"
#include "core/tracing/tree/vessel_graph.h"
#include "core/tracing/volume/voxels/beyond_rim.h"
#include "core/tracing/volume/voxels/distance_map.h"
#include "core/tracing/volume/voxels/thin_volume.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

Eigen::Vector3d onGrid(const Eigen::Vector3d& inPatient, const VolumeGeometry& grid)
{
    return grid.spacingMm.cwiseProduct(grid.patientFromVoxel().inverse() * inPatient);
}

std::vector<Eigen::Vector3d> startsOn(const VolumeGeometry& grid, const VesselTracingOptions& options)
{
    std::vector<Eigen::Vector3d> startsMm;
    for (const Eigen::Vector3d& seed : options.seedsInPatient) {
        startsMm.push_back(onGrid(seed, grid));
    }
    return startsMm;
}

std::vector<BranchPath> pathsIn(const VesselGraph& graph, const VesselTracingOptions& options,
                                const VolumeGeometry& grid)
{
    std::optional<Eigen::Vector3d> rootMm;
    if (options.rootInPatient) {
        rootMm = onGrid(*options.rootInPatient, grid);
    }
    return branchPaths(graph, rootMm, startsOn(grid, options));
}

/// Skeleton of the lumen without what lies beyond the rim.
std::vector<std::size_t> skeletonOf(const VoxelMask& lumen, TracingProgress& progress)
{
    WiderMask wider = continuedBeyondRim(lumen);
    const VolumeGeometry grid = wider.mask.geometry;
    std::vector<std::size_t> within;
    for (const std::size_t voxel : thinnedInPlace(std::move(wider.mask), progress)) {
        const Eigen::Vector3i place = grid.voxelAt(voxel) - wider.offset;
        if (lumen.geometry.contains(place)) {
            within.push_back(lumen.geometry.index(place.x(), place.y(), place.z()));
        }
    }
    return within;
}

VesselGraph prunedGraph(const VoxelMask& lumen, const BloodFill& fill, const VesselTracingOptions& options,
                        TracingProgress& progress, LumenTree& found)
{
    progress.enter("thinning", 0.7, 0.8);
    const DistanceMap distances = distanceMap(lumen, threadCount(options.threads), progress);
    const std::vector<std::size_t> skeleton = skeletonOf(lumen, progress);
    if (progress.isStopped()) {
        return {};
    }
    progress.enter("branches", 0.8, 1.0);
    VesselGraph graph = vesselGraph(skeleton, distances);
    found.openedLoops = openLoops(graph);
    const SpurLimits limits{.minLengthMm = options.minBranchLengthMm, .minRadiusMm = options.minBranchRadiusMm};
    pruneSpurs(graph, limits);
    found.dimParts = dropDimParts(graph, fill, startsOn(lumen.geometry, options), lumen.geometry.spacingMm.maxCoeff());
    pruneSpurs(graph, limits);
    return graph;
}

VesselBranch branchOf(const VesselCurve& curve, int id, int generation, const VolumeGeometry& grid)
{
    VesselBranch branch;
    branch.id = id;
    branch.generation = generation;
    branch.radiusMm = curve.radiusMm;
    for (const Eigen::Vector3d& point : curve.pointsMm) {
        branch.pointsInPatient.emplace_back(grid.originInPatient + grid.direction * point);
    }
    return branch;
}

}   // namespace

LumenTree lumenTree(const VoxelMask& lumen, const BloodFill& fill, const VesselTracingOptions& options,
                    TracingProgress& progress)
{
    LumenTree result;
    const VolumeGeometry& grid = lumen.geometry;
    const VesselGraph graph = prunedGraph(lumen, fill, options, progress, result);
    const std::vector<BranchPath> paths = pathsIn(graph, options, grid);
    const CurveSettings settings{grid.spacingMm.minCoeff(), options.pointSpacingMm, Eigen::Vector3d::Zero(),
                                 grid.spacingMm.cwiseProduct((grid.size.array() - 1).cast<double>().matrix())};
    std::vector<VesselCurve> curves;
    for (const BranchPath& path : paths) {
        const VesselCurve* parent = path.parent >= 0 ? &curves[static_cast<std::size_t>(path.parent)] : nullptr;
        curves.push_back(vesselCurve(path, parent, fill, settings));
        result.tree.branches.push_back(branchOf(curves.back(), static_cast<int>(curves.size()), path.generation, grid));
        if (!progress.advance(static_cast<double>(curves.size()) / static_cast<double>(paths.size()))) {
            return {};
        }
    }
    return result;
}

BloodFill fillOf(const VoxelMask& mask)
{
    return [&mask](const Eigen::Vector3d& pointMm) {
        return interpolated(mask.geometry, pointMm, [&mask](const Eigen::Vector3i& at) {
            return mask.at(at.x(), at.y(), at.z()) != 0 ? 1.0 : 0.0;
        });
    };
}

}   // namespace angiopose::core
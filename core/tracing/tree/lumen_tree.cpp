#include "core/tracing/tree/lumen_tree.h"

#include "core/imaging/interpolate_grid.h"
#include "core/imaging/volume.h"
#include "core/support/parallel_for.h"
#include "core/tracing/tree/boundary_stubs.h"
#include "core/tracing/tree/branch_paths.h"
#include "core/tracing/tree/dim_subtrees.h"
#include "core/tracing/tree/prune_spurs.h"
#include "core/tracing/tree/tree_from_paths.h"
#include "core/tracing/tree/vessel_curve.h"
#include "core/tracing/tree/vessel_graph.h"
#include "core/tracing/volume/voxels/distance_map.h"
#include "core/tracing/volume/voxels/thin_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace angiopose::core {
namespace {

/// Mask padded on all sides: voxel p of the original is voxel p + `offset` here. The outermost voxels are clear.
struct PaddedMask {
    VoxelMask mask;
    Eigen::Vector3i offset = Eigen::Vector3i::Ones();
};

constexpr double maxCutAspectRatio = 2.5;   ///< maximum aspect ratio of a cut across a vessel
constexpr int maxLayers = 60;

/// One side of the grid: the plane at `position` across `axis`; `outwards` is -1 or +1.
struct Face {
    int axis = 0;
    int position = 0;
    int outwards = 1;
};

/// Intersection of the lumen with a face, and the number of layers to add beyond the face.
struct Cut {
    Face face;
    std::vector<Eigen::Vector3i> voxels;
    int layers = 0;
};

/// Returns the number of layers for a cut: slightly more than its radius if it is round, none if it is elongated.
int layersOf(const std::vector<Eigen::Vector3i>& voxels, int axis)
{
    Eigen::Vector3i low = voxels.front();
    Eigen::Vector3i high = voxels.front();
    for (const Eigen::Vector3i& voxel : voxels) {
        low = low.cwiseMin(voxel);
        high = high.cwiseMax(voxel);
    }
    const Eigen::Vector3i extent = (high - low).array() + 1;
    const int a = extent[(axis + 1) % 3];
    const int b = extent[(axis + 2) % 3];
    if (std::max(a, b) > maxCutAspectRatio * std::min(a, b)) {
        return 0;
    }
    const double radius = std::sqrt(static_cast<double>(voxels.size()) / std::numbers::pi);
    return std::min(maxLayers, static_cast<int>(std::ceil(1.2 * radius)) + 1);
}

/// Finds the connected cuts in one face.
void findCuts(const VoxelMask& mask, const Face& face, std::vector<Cut>& cuts)
{
    const Eigen::Vector3i& size = mask.geometry.size;
    const int u = (face.axis + 1) % 3;
    const int v = (face.axis + 2) % 3;
    std::vector<std::uint8_t> seen(static_cast<std::size_t>(size[u]) * static_cast<std::size_t>(size[v]), 0);
    const auto voxelAt = [&](int a, int b) {
        Eigen::Vector3i voxel;
        voxel[face.axis] = face.position;
        voxel[u] = a;
        voxel[v] = b;
        return voxel;
    };
    const auto take = [&](int a, int b) {
        if (a < 0 || b < 0 || a >= size[u] || b >= size[v]) {
            return false;
        }
        std::uint8_t& isSeen =
            seen[static_cast<std::size_t>(b) * static_cast<std::size_t>(size[u]) + static_cast<std::size_t>(a)];
        const Eigen::Vector3i voxel = voxelAt(a, b);
        const bool isNew = isSeen == 0 && mask.at(voxel.x(), voxel.y(), voxel.z()) != 0;
        isSeen = 1;
        return isNew;
    };
    for (int b = 0; b < size[v]; ++b) {
        for (int a = 0; a < size[u]; ++a) {
            if (!take(a, b)) {
                continue;
            }
            Cut cut{face, {voxelAt(a, b)}, 0};
            for (std::size_t n = 0; n < cut.voxels.size(); ++n) {
                const Eigen::Vector3i at = cut.voxels[n];
                for (const auto& [da, db] : std::array<std::array<int, 2>, 4>{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}}) {
                    if (take(at[u] + da, at[v] + db)) {
                        cut.voxels.push_back(voxelAt(at[u] + da, at[v] + db));
                    }
                }
            }
            cut.layers = layersOf(cut.voxels, face.axis);
            cuts.push_back(std::move(cut));
        }
    }
}

/// Extends vessels that are cut by the grid boundary by slightly more than their radius. Thinning shortens a vessel end
/// by about that much and would otherwise lose the last segment, or a short wide trunk entirely. Vessels along the
/// boundary are not extended.
PaddedMask extendBeyondBoundary(const VoxelMask& mask)
{
    const Eigen::Vector3i& size = mask.geometry.size;
    std::vector<Cut> cuts;
    for (int axis = 0; axis < 3; ++axis) {
        findCuts(mask, {axis, 0, -1}, cuts);
        findCuts(mask, {axis, size[axis] - 1, 1}, cuts);
    }
    PaddedMask padded;
    Eigen::Vector3i after = Eigen::Vector3i::Ones();
    for (const Cut& cut : cuts) {
        int& padding = cut.face.outwards < 0 ? padded.offset[cut.face.axis] : after[cut.face.axis];
        padding = std::max(padding, cut.layers + 1);
    }
    VolumeGeometry grid;
    grid.size = size + padded.offset + after;
    padded.mask = VoxelMask(grid);
    for (int k = 0; k < size.z(); ++k) {
        for (int j = 0; j < size.y(); ++j) {
            const Eigen::Vector3i to = Eigen::Vector3i(0, j, k) + padded.offset;
            std::copy_n(&mask.at(0, j, k), size.x(), &padded.mask.at(to.x(), to.y(), to.z()));
        }
    }
    for (const Cut& cut : cuts) {
        for (const Eigen::Vector3i& voxel : cut.voxels) {
            for (int layer = 1; layer <= cut.layers; ++layer) {
                Eigen::Vector3i to = voxel + padded.offset;
                to[cut.face.axis] += layer * cut.face.outwards;
                padded.mask.at(to.x(), to.y(), to.z()) = 1;
            }
        }
    }
    return padded;
}

constexpr double minLoopInBranches = 4.0;   ///< minimum circumference of a kept loop, in minimum branch lengths

Eigen::Vector3d toGridMm(const Eigen::Vector3d& inPatient, const VolumeGeometry& grid)
{
    return grid.spacingMm.cwiseProduct(grid.patientFromVoxel().inverse() * inPatient);
}

std::vector<Eigen::Vector3d> startsOnGrid(const VolumeGeometry& grid, const VesselTracingOptions& options)
{
    std::vector<Eigen::Vector3d> startsMm;
    for (const Eigen::Vector3d& seed : options.seedsInPatient) {
        startsMm.push_back(toGridMm(seed, grid));
    }
    return startsMm;
}

std::vector<BranchPath> tracePaths(const VesselGraph& graph, const VesselTracingOptions& options,
                                   const VolumeGeometry& grid)
{
    std::optional<Eigen::Vector3d> rootMm;
    if (options.rootInPatient) {
        rootMm = toGridMm(*options.rootInPatient, grid);
    }
    const PathComponents pieces = options.pieces == TracedPieces::All ? PathComponents::All : PathComponents::First;
    return splitIntoPaths(graph, rootMm, startsOnGrid(grid, options), pieces);
}

LoopCount applyLoopOption(VesselGraph& graph, const VesselTracingOptions& options, TracingProgress& progress)
{
    return options.loops == VesselLoops::Kept
               ? openSmallLoops(graph, minLoopInBranches * options.minBranchLengthMm, progress)
               : LoopCount{openLoops(graph), 0};
}

/// Removes dim subtrees from the spanning forest, then restores the loop-closing edges whose end nodes both remain.
int removeDimSubtreesOnly(VesselGraph& graph, const PointOpacification& opacification, const VolumeGeometry& grid,
                          const VesselTracingOptions& options)
{
    const bool hasLoops = options.loops == VesselLoops::Kept;
    const std::vector<VesselEdge> closing = hasLoops ? extractClosingEdges(graph) : std::vector<VesselEdge>();
    const std::vector<int> before = graph.degrees();
    const int dropped = removeDimSubtrees(graph, opacification, startsOnGrid(grid, options), grid.spacingMm.maxCoeff());
    const std::vector<int> after = graph.degrees();
    const auto hasEdges = [&](int node) {
        return after[static_cast<std::size_t>(node)] > 0 || before[static_cast<std::size_t>(node)] == 0;   // ring
    };
    for (const VesselEdge& edge : closing) {
        if (hasEdges(edge.startNode) && hasEdges(edge.endNode)) {
            graph.edges.push_back(edge);
        }
    }
    return dropped;
}

/// Computes the skeleton of the lumen on a mask extended beyond the grid boundary, then restricts it to the grid.
std::vector<std::size_t> skeletonOf(const VoxelMask& lumen, TracingProgress& progress)
{
    PaddedMask padded = extendBeyondBoundary(lumen);
    const VolumeGeometry grid = padded.mask.geometry;
    std::vector<std::size_t> within;
    for (const std::size_t voxel : skeletonizeInPlace(std::move(padded.mask), progress)) {
        const Eigen::Vector3i place = grid.voxelAt(voxel) - padded.offset;
        if (lumen.geometry.contains(place)) {
            within.push_back(lumen.geometry.index(place.x(), place.y(), place.z()));
        }
    }
    return within;
}

void closeGapsIfRequested(VesselGraph& graph, const VolumeGeometry& grid, const VesselTracingOptions& options,
                          TracingProgress& progress, LumenTree& output)
{
    if (options.pieces == TracedPieces::All) {
        const ClosedGaps closed = closeClearGaps(graph, grid.spacingMm.maxCoeff(), progress);
        output.closedGaps.count += closed.count;
        output.closedGaps.maxGapMm = std::max(output.closedGaps.maxGapMm, closed.maxGapMm);
    }
}

VesselGraph prunedGraph(const VoxelMask& lumen, const PointOpacification& opacification,
                        const VesselTracingOptions& options, TracingProgress& progress, LumenTree& output)
{
    progress.enter("thinning", 0.7, 0.8);
    const DistanceMap distances = distanceMap(lumen, threadCount(options.threads), progress);
    output.skeleton = skeletonOf(lumen, progress);
    if (progress.isStopped()) {
        return {};
    }
    progress.enter("branches", 0.8, 1.0);
    VesselGraph graph = buildVesselGraph(output.skeleton, distances, progress);
    output.loops = applyLoopOption(graph, options, progress);
    const SpurLimits limits{.minLengthMm = options.minBranchLengthMm, .minRadiusMm = options.minBranchRadiusMm};
    closeGapsIfRequested(graph, lumen.geometry, options, progress, output);
    pruneSpurs(graph, limits, progress);
    closeGapsIfRequested(graph, lumen.geometry, options, progress, output);   // ends are more reliable without spurs
    output.dimSubtrees = removeDimSubtreesOnly(graph, opacification, lumen.geometry, options);
    pruneSpurs(graph, limits, progress);
    return graph;
}

/// Returns the indices of the paths that are not stubs at the grid boundary.
std::vector<std::size_t> selectBranches(const std::vector<BranchPath>& paths, const std::vector<VesselCurve>& curves,
                                        const VoxelMask& lumen, double minMm)
{
    std::vector<bool> isLeaf(paths.size(), true);
    for (const BranchPath& path : paths) {
        for (const int other : {path.parent, path.loopTarget}) {
            if (other >= 0) {
                isLeaf[static_cast<std::size_t>(other)] = false;
            }
        }
    }
    std::vector<std::size_t> branches;
    for (std::size_t n = 0; n < paths.size(); ++n) {
        const bool canBeStub = isLeaf[n] && paths[n].loopTarget < 0;
        const bool isStub =
            canBeStub &&
            (paths[n].parent >= 0
                 ? isBoundaryStub(curves[n], curves[static_cast<std::size_t>(paths[n].parent)], lumen, minMm)
                 : isBoundaryFragment(curves[n], lumen, minMm));
        if (!isStub) {
            branches.push_back(n);
        }
    }
    return branches;
}

}   // namespace

LumenTree traceLumenTree(const VoxelMask& lumen, const PointOpacification& opacification,
                         const VesselTracingOptions& options, TracingProgress& progress)
{
    LumenTree result;
    const VolumeGeometry& grid = lumen.geometry;
    const VesselGraph graph = prunedGraph(lumen, opacification, options, progress, result);
    const std::vector<BranchPath> paths = tracePaths(graph, options, grid);
    const std::vector<VesselCurve> curves = curvesFromPaths(
        paths, [&opacification](const BranchPath&) { return opacification; }, grid, options.pointSpacingMm, progress);
    if (curves.size() < paths.size()) {
        return {};
    }
    for (const std::size_t n : selectBranches(paths, curves, lumen, options.minBranchLengthMm)) {
        const int id = static_cast<int>(result.tree.branches.size()) + 1;
        result.tree.branches.push_back(branchFromCurve(curves[n], id, paths[n].generation, grid));
    }
    return result;
}

PointOpacification opacificationIn(const VoxelMask& mask)
{
    return [&mask](const Eigen::Vector3d& pointMm) {
        return interpolateTrilinear(mask.geometry, pointMm, [&mask](const Eigen::Vector3i& at) {
            return mask.at(at.x(), at.y(), at.z()) != 0 ? 1.0 : 0.0;
        });
    };
}

}   // namespace angiopose::core

#include "core/tracing/volume/path/vessel_path.h"

#include "core/imaging/mark_ball.h"
#include "core/imaging/reduce_volume.h"
#include "core/messages/messages.h"
#include "core/tracing/tree/tree_from_paths.h"
#include "core/tracing/volume/chosen/selected_lumen.h"
#include "core/tracing/volume/path/appearance_along_path.h"
#include "core/tracing/volume/path/minimal_path.h"
#include "core/tracing/volume/path/path_end.h"
#include "core/tracing/volume/path/voxel_cost.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace angiopose::core {
namespace {

std::vector<Eigen::Vector3i> findPathBetween(const TubeDetector& detector, const PathEnd& from, const PathEnd& to,
                                             TracingProgress& progress);

constexpr std::size_t maxSettledFirst = 30'000;   // voxels settled before switching to blocks; thin vessels need fewer
constexpr std::size_t maxSettled = 3'000'000;
constexpr double coarsestMm = 3.2;   // maximum side of the blocks
constexpr double nearReachInBlocks = 2.5;   // search radius around the coarse path
constexpr double minNearMm = 4.0;

/// Expected appearance of the vessels between both ends, linearly interpolated.
class InterpolatedAppearance {
public:
    InterpolatedAppearance(const Eigen::Vector3d& fromMm, const VesselAppearance& from, const Eigen::Vector3d& toMm,
                           const VesselAppearance& to)
        : fromMm_(fromMm), span_(toMm - fromMm), from_(from), to_(to)
    {
    }

    VesselAppearance at(const Eigen::Vector3d& pointMm) const
    {
        const double share =
            std::clamp((pointMm - fromMm_).dot(span_) / std::max(span_.squaredNorm(), 1e-12), 0.0, 1.0);
        return {from_.blood + share * (to_.blood - from_.blood), from_.tissue + share * (to_.tissue - from_.tissue)};
    }

private:
    Eigen::Vector3d fromMm_;
    Eigen::Vector3d span_;
    VesselAppearance from_;
    VesselAppearance to_;
};

VoxelCost costBetween(const TubeDetector& detector, const PathEnd& from, const PathEnd& to)
{
    const Eigen::Vector3d spacing = detector.volume().geometry.spacingMm;
    const InterpolatedAppearance appearance(from.voxel.cast<double>().cwiseProduct(spacing), from.appearance,
                                            to.voxel.cast<double>().cwiseProduct(spacing), to.appearance);
    return {[&detector, appearance, spacing](const Eigen::Vector3i& voxel) {
                return costOfVoxel(detector, voxel, appearance.at(voxel.cast<double>().cwiseProduct(spacing)));
            },
            minCostPerMm};
}

/// Returns the block size in voxels: approximately cubic, twice the shortest voxel side.
Eigen::Vector3i blockOf(const VolumeGeometry& grid)
{
    const double sideMm = 2.0 * grid.spacingMm.minCoeff();
    return (sideMm / grid.spacingMm.array()).round().max(1.0).cast<int>();
}

PathEnd endInBlocks(const TubeDetector& blocks, const Eigen::Vector3i& voxel)
{
    PathEnd end;
    end.voxel = voxel;
    end.appearance = blocks.appearanceAt(voxel);
    end.appearance.blood = std::max(end.appearance.blood, end.appearance.tissue + 1.0);
    return end;
}

/// Returns the blocks near the coarse path.
VoxelMask markNearPath(const std::vector<Eigen::Vector3i>& way, const VolumeGeometry& blocks)
{
    VoxelMask near(blocks);
    const double reachMm = std::max(minNearMm, nearReachInBlocks * blocks.spacingMm.maxCoeff());
    for (const Eigen::Vector3i& block : way) {
        markBall(blocks.patientFromVoxel() * block.cast<double>(), reachMm, near);
    }
    return near;
}

std::vector<Eigen::Vector3i> findPathViaBlocks(const TubeDetector& detector, const PathEnd& from, const PathEnd& to,
                                               const VoxelCost& cost, TracingProgress& progress)
{
    const VolumeGeometry& grid = detector.volume().geometry;
    const Eigen::Vector3i block = blockOf(grid);
    const VoxelRange range = searchRange(grid, from.voxel, to.voxel);
    const auto means = averageBlocks(detector.volume(), range, block, [&] { return progress.advance(0.0); });
    if (!means) {
        return {};
    }
    const TubeDetector blocks(*means);
    const auto blockAt = [&](const Eigen::Vector3i& voxel) {
        return ((voxel - range.low).array() / block.array()).matrix().eval();
    };
    const std::vector<Eigen::Vector3i> way = findPathBetween(blocks, endInBlocks(blocks, blockAt(from.voxel)),
                                                             endInBlocks(blocks, blockAt(to.voxel)), progress);
    if (way.empty()) {
        return {};
    }
    const VoxelMask near = markNearPath(way, means->geometry);
    const VoxelCost nearby{[&](const Eigen::Vector3i& voxel) {
                               const Eigen::Vector3i at = blockAt(voxel);
                               return near.at(at.x(), at.y(), at.z()) != 0 ? cost.perMm(voxel)
                                                                           : std::numeric_limits<double>::infinity();
                           },
                           cost.minPerMm};
    return findMinimalPath(grid, from.voxel, to.voxel, nearby, maxSettled, progress).voxels;
}

/// Finds the cheapest path between both ends, inclusive, through voxels that look like the ends (ALGORITHMS §9.12). If
/// a limited search fails, searches a coarse path over blocks of voxels first and then the voxels near that path. Empty
/// if stopped or if there is no path.
std::vector<Eigen::Vector3i> findPathBetween(const TubeDetector& detector, const PathEnd& from, const PathEnd& to,
                                             TracingProgress& progress)
{
    const VolumeGeometry& grid = detector.volume().geometry;
    const VoxelCost cost = costBetween(detector, from, to);
    const bool isCoarsest = 2.0 * grid.spacingMm.minCoeff() > coarsestMm;
    MinimalPath path =
        findMinimalPath(grid, from.voxel, to.voxel, cost, isCoarsest ? maxSettled : maxSettledFirst, progress);
    return path.isTruncated && !isCoarsest ? findPathViaBlocks(detector, from, to, cost, progress)
                                           : std::move(path.voxels);
}

constexpr double outsideFill = 0.35;   // minimum opacification of a vessel
constexpr double minReportedMm = 2.0;
constexpr double assumedRadiusMm = 1.5;   // radius assumed for the first cross-sections
constexpr double pointSpacingMm = 1.0;

std::vector<Eigen::Vector3d> toPointsMm(const std::vector<Eigen::Vector3i>& path, const VolumeGeometry& grid)
{
    std::vector<Eigen::Vector3d> pathPointsMm;
    for (const Eigen::Vector3i& voxel : path) {
        pathPointsMm.emplace_back(voxel.cast<double>().cwiseProduct(grid.spacingMm));
    }
    return pathPointsMm;
}

/// Converts the path to a smooth, centered curve with radii.
VesselBranch centeredBranch(const std::vector<Eigen::Vector3d>& pathPointsMm, const VolumeGeometry& grid,
                            const AppearanceAlongPath& appearance, TracingProgress& progress)
{
    BranchPath way;
    way.pointsMm = pathPointsMm;
    way.radiusMm.assign(pathPointsMm.size(), std::max(assumedRadiusMm, grid.spacingMm.minCoeff()));
    const auto opacification = [&appearance](const BranchPath&) { return appearance.cachedOpacification(); };
    VesselTree tree = treeFromPaths({way}, opacification, grid, pointSpacingMm, progress);
    VesselBranch branch = tree.branches.empty() ? VesselBranch() : std::move(tree.branches.front());
    branch.id = 0;
    branch.generation = -1;
    return branch;
}

/// Returns the length of the path outside any vessel.
double lengthOutside(const std::vector<Eigen::Vector3d>& pathPointsMm, const AppearanceAlongPath& appearance)
{
    double outsideMm = 0.0;
    for (std::size_t n = 1; n < pathPointsMm.size(); ++n) {
        outsideMm += appearance.opacification(pathPointsMm[n]) < outsideFill
                         ? (pathPointsMm[n] - pathPointsMm[n - 1]).norm()
                         : 0.0;
    }
    return outsideMm;
}

}   // namespace

Result<VesselPath> traceVesselBetween(const Volume& volume, const Eigen::Vector3d& fromInPatient,
                                      const Eigen::Vector3d& toInPatient, const TracingObserver& observe)
{
    TracingProgress progress(observe);
    const TubeDetector detector(volume);
    const auto from = findPathEnd(detector, fromInPatient);
    const auto to = from ? findPathEnd(detector, toInPatient) : from;
    if (!to) {
        return to.error();
    }
    if (from.value().voxel == to.value().voxel) {
        return Error(messages::pathEndsTooNear());
    }
    progress.enter("path", 0.0, 1.0);
    const std::vector<Eigen::Vector3i> path = findPathBetween(detector, from.value(), to.value(), progress);
    if (progress.isStopped()) {
        return tracingCanceled();
    }
    if (path.empty()) {
        return Error(messages::pathNotFound());
    }
    const std::vector<Eigen::Vector3d> pathPointsMm = toPointsMm(path, volume.geometry);
    const AppearanceAlongPath along(detector, pathPointsMm);
    VesselPath traced;
    traced.branch = centeredBranch(pathPointsMm, volume.geometry, along, progress);
    traced.outsideMm = lengthOutside(pathPointsMm, along);
    if (progress.isStopped()) {
        return tracingCanceled();
    }
    if (traced.outsideMm >= minReportedMm) {
        traced.warnings.push_back(messages::pathOutside(Quantity{traced.outsideMm, 0, "mm"}));
    }
    return traced;
}

}   // namespace angiopose::core

#include "core/tracing/volume/path/vessel_path.h"

#include "core/messages/messages.h"
#include "core/tracing/tree/tree_of_paths.h"
#include "core/tracing/volume/chosen/chosen_lumen.h"
#include "core/tracing/volume/path/look_along_path.h"
#include "core/tracing/volume/path/path_end.h"
#include "core/tracing/volume/path/way_between.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double outsideFill = 0.35;   // lower values: no vessel
constexpr double sayOutsideMm = 2.0;
constexpr double assumedRadiusMm = 1.5;   // radius assumed for the first cross-sections
constexpr double pointSpacingMm = 1.0;

std::vector<Eigen::Vector3d> placesOf(const std::vector<Eigen::Vector3i>& path, const VolumeGeometry& grid)
{
    std::vector<Eigen::Vector3d> placesMm;
    for (const Eigen::Vector3i& voxel : path) {
        placesMm.emplace_back(voxel.cast<double>().cwiseProduct(grid.spacingMm));
    }
    return placesMm;
}

/// Converts the path to a smooth, centered curve with radii.
VesselBranch centerdBranch(const std::vector<Eigen::Vector3d>& placesMm, const VolumeGeometry& grid,
                           const LookAlongPath& look, TracingProgress& progress)
{
    BranchPath way;
    way.pointsMm = placesMm;
    way.radiusMm.assign(placesMm.size(), std::max(assumedRadiusMm, grid.spacingMm.minCoeff()));
    const auto fill = [&look](const BranchPath&) { return look.quickFill(); };
    VesselTree tree = treeOfPaths({way}, fill, grid, pointSpacingMm, progress);
    VesselBranch branch = tree.branches.empty() ? VesselBranch() : std::move(tree.branches.front());
    branch.id = 0;
    branch.generation = -1;
    return branch;
}

/// Length of the path outside any vessel.
double lengthOutside(const std::vector<Eigen::Vector3d>& placesMm, const LookAlongPath& look)
{
    double outsideMm = 0.0;
    for (std::size_t n = 1; n < placesMm.size(); ++n) {
        outsideMm += look.fill(placesMm[n]) < outsideFill ? (placesMm[n] - placesMm[n - 1]).norm() : 0.0;
    }
    return outsideMm;
}

}   // namespace

Result<VesselPath> vesselBetween(const Volume& volume, const Eigen::Vector3d& fromInPatient,
                                 const Eigen::Vector3d& toInPatient, const TracingObserver& observe)
{
    TracingProgress progress(observe);
    const PathGround ground(volume);
    const auto from = pathEnd(ground, fromInPatient);
    const auto to = from ? pathEnd(ground, toInPatient) : from;
    if (!to) {
        return to.error();
    }
    if (from.value().voxel == to.value().voxel) {
        return Error(messages::pathEndsTooNear());
    }
    progress.enter("path", 0.0, 1.0);
    const std::vector<Eigen::Vector3i> path = wayBetween(ground, from.value(), to.value(), progress);
    if (progress.isStopped()) {
        return stoppedTracing();
    }
    if (path.empty()) {
        return Error(messages::pathNotFound());
    }
    const std::vector<Eigen::Vector3d> placesMm = placesOf(path, volume.geometry);
    const LookAlongPath along(ground, placesMm);
    VesselPath found;
    found.branch = centerdBranch(placesMm, volume.geometry, along, progress);
    found.outsideMm = lengthOutside(placesMm, along);
    if (progress.isStopped()) {
        return stoppedTracing();
    }
    if (found.outsideMm >= sayOutsideMm) {
        found.warnings.push_back(messages::pathOutside(Quantity{found.outsideMm, 0, "mm"}));
    }
    return found;
}

}   // namespace angiopose::core

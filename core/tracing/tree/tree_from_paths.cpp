#include "core/tracing/tree/tree_from_paths.h"

namespace angiopose::core {

std::vector<VesselCurve> curvesFromPaths(const std::vector<BranchPath>& paths,
                                         const PathOpacification& opacificationAlong, const VolumeGeometry& grid,
                                         double pointSpacingMm, TracingProgress& progress)
{
    const CurveSettings settings{grid.spacingMm.minCoeff(), pointSpacingMm, Eigen::Vector3d::Zero(),
                                 grid.spacingMm.cwiseProduct((grid.size.array() - 1).cast<double>().matrix()),
                                 &progress};
    std::vector<VesselCurve> curves;
    for (const BranchPath& path : paths) {
        const auto curveOf = [&curves](int index) {
            const bool isFinished = index >= 0 && index < static_cast<int>(curves.size());
            return isFinished ? &curves[static_cast<std::size_t>(index)] : nullptr;
        };
        const CurveNeighbors neighbors{curveOf(path.parent), curveOf(path.loopTarget),
                                       path.loopTarget == static_cast<int>(curves.size())};
        curves.push_back(fitVesselCurve(path, neighbors, opacificationAlong(path), settings));
        if (!progress.advance(static_cast<double>(curves.size()) / static_cast<double>(paths.size()))) {
            return {};
        }
    }
    return curves;
}

VesselBranch branchFromCurve(const VesselCurve& curve, int id, int generation, const VolumeGeometry& grid)
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

VesselTree treeFromPaths(const std::vector<BranchPath>& paths, const PathOpacification& opacificationAlong,
                         const VolumeGeometry& grid, double pointSpacingMm, TracingProgress& progress)
{
    VesselTree tree;
    for (const VesselCurve& curve : curvesFromPaths(paths, opacificationAlong, grid, pointSpacingMm, progress)) {
        const int generation = paths[tree.branches.size()].generation;
        tree.branches.push_back(branchFromCurve(curve, static_cast<int>(tree.branches.size()) + 1, generation, grid));
    }
    return tree;
}

}   // namespace angiopose::core

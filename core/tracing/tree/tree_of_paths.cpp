#include "core/tracing/tree/tree_of_paths.h"

#include "core/tracing/tree/vessel_curve.h"

namespace angiopose::core {
namespace {

VesselBranch branchOfCurve(const VesselCurve& curve, int id, int generation, const VolumeGeometry& grid)
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

VesselTree treeOfPaths(const std::vector<BranchPath>& paths, const FillOfPath& fillOf, const VolumeGeometry& grid,
                       double pointSpacingMm, TracingProgress& progress)
{
    const CurveSettings settings{grid.spacingMm.minCoeff(), pointSpacingMm, Eigen::Vector3d::Zero(),
                                 grid.spacingMm.cwiseProduct((grid.size.array() - 1).cast<double>().matrix())};
    VesselTree tree;
    std::vector<VesselCurve> curves;
    for (const BranchPath& path : paths) {
        const VesselCurve* parent = path.parent >= 0 ? &curves[static_cast<std::size_t>(path.parent)] : nullptr;
        curves.push_back(vesselCurve(path, parent, fillOf(path), settings));
        tree.branches.push_back(branchOfCurve(curves.back(), static_cast<int>(curves.size()), path.generation, grid));
        if (!progress.advance(static_cast<double>(curves.size()) / static_cast<double>(paths.size()))) {
            return {};
        }
    }
    return tree;
}

}   // namespace angiopose::core

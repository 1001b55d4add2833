#include "tests/support/bodies/body_shapes.h"

#include <utility>

namespace angiopose::core {

void paintEllipsoid(ScanPainter& painter, const TurnedEllipsoid& shape, double hu)
{
    painter.forEachVoxelAround(shape.center, Eigen::Vector3d::Constant(shape.halfAxesMm.maxCoeff()),
                               [&](std::size_t voxel, const Eigen::Vector3d& place) {
                                   painter.blend(voxel, fractionInside(shape.distanceMm(place), painter.voxelMm()), hu);
                               });
}

void paintDifference(ScanPainter& painter, const TurnedEllipsoid& shape, const TurnedEllipsoid& without, double hu)
{
    painter.forEachVoxelAround(shape.center, Eigen::Vector3d::Constant(shape.halfAxesMm.maxCoeff()),
                               [&](std::size_t voxel, const Eigen::Vector3d& place) {
                                   const double outsideMm =
                                       std::max(shape.distanceMm(place), -without.distanceMm(place));
                                   painter.blend(voxel, fractionInside(outsideMm, painter.voxelMm()), hu);
                               });
}

VesselBranch taperedBranch(std::vector<Eigen::Vector3d> points, double firstRadiusMm, double lastRadiusMm)
{
    VesselBranch branch;
    const double last = std::max(1.0, static_cast<double>(points.size()) - 1.0);
    for (std::size_t n = 0; n < points.size(); ++n) {
        branch.radiusMm.push_back(firstRadiusMm + static_cast<double>(n) / last * (lastRadiusMm - firstRadiusMm));
    }
    branch.pointsInPatient = std::move(points);
    return branch;
}

void addBranch(VesselTree& tree, VesselBranch branch, int generation)
{
    branch.id = static_cast<int>(tree.branches.size()) + 1;
    branch.generation = generation;
    tree.branches.push_back(std::move(branch));
}

}   // namespace angiopose::core

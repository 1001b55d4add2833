#include "core/evaluation/trial/branch_distances.h"

#include "core/registration/matching/kd_tree_index.h"

#include <limits>

namespace angiopose::core {
namespace {

constexpr double targetSpacingPx = 0.5;   // small enough for the nearest sample to approximate the nearest curve point

std::vector<Eigen::Vector2d> densePoints(const Centerline2d& target)
{
    std::vector<Eigen::Vector2d> points;
    for (const Curve2d& curve : resampled(target, targetSpacingPx).curves) {
        points.insert(points.end(), curve.pointsPx.begin(), curve.pointsPx.end());
    }
    return points;
}

}   // namespace

std::map<int, std::vector<double>> branchDistances(const VesselTree& tree, const Centerline2d& target,
                                                   const ProjectionCamera& camera,
                                                   const RigidTransform& cameraFromPatient)
{
    std::map<int, std::vector<double>> distances;
    if (target.pointCount() == 0) {
        return distances;
    }
    const auto index = makeKdTreeIndex(densePoints(target));
    for (const VesselBranch& branch : tree.branches) {
        std::vector<double>& values = distances[branch.id];
        values.reserve(branch.pointsInPatient.size());
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            const auto pixel = project(camera, cameraFromPatient * point);
            values.push_back(pixel ? (*pixel - index->nearest(*pixel)).norm()
                                   : std::numeric_limits<double>::infinity());
        }
    }
    return distances;
}

}   // namespace angiopose::core

#include "core/simulation/simulated_case.h"

namespace angiopose::core {
namespace {

constexpr double imageSpacingPx = 1.0;

}   // namespace

Centerline2d projectTree(const VesselTree& tree, const ProjectionCamera& camera,
                         const RigidTransform& cameraFromPatient)
{
    Centerline2d target;
    for (const VesselBranch& branch : tree.branches) {
        const bool hasRadii = branch.radiusMm.size() == branch.pointsInPatient.size();
        Curve2d curve{branch.id, {}, {}};
        for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
            const Eigen::Vector3d pointInCamera = cameraFromPatient * branch.pointsInPatient[i];
            const std::optional<Eigen::Vector2d> pixel = project(camera, pointInCamera);
            if (!pixel) {
                continue;
            }
            curve.pointsPx.push_back(*pixel);
            if (hasRadii) {
                curve.radiusPx.push_back(branch.radiusMm[i] / millimetersPerPixel(camera, pointInCamera.z()));
            }
        }
        if (!curve.pointsPx.empty()) {
            target.curves.push_back(std::move(curve));
        }
    }
    return target;
}

Centerline2d projectCurves(const VesselTree& tree, const ProjectionCamera& camera,
                           const RigidTransform& cameraFromPatient)
{
    return resampled(projectTree(tree, camera, cameraFromPatient), imageSpacingPx);
}

}   // namespace angiopose::core

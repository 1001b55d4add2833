#include "core/registration/deformable/knot_projection.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double minSeenShare =
    0.25;   // minimum projected fraction of the length; a vessel along the ray has no direction in the image

/// Returns the unnormalized tangent of the deformed branch at a knot, patient axes.
Eigen::Vector3d deformedTangent(const TreeKnots& knots, const DeformedTree& deformed, std::size_t branch,
                                std::size_t knot)
{
    const std::size_t before = std::max(knot, knots.firstOfBranch[branch] + 1) - 1;
    const std::size_t after = std::min(knot + 1, knots.firstOfBranch[branch + 1] - 1);
    const double apart = (knots.positions[after] - knots.positions[before]).norm();
    if (!(apart > 0.5)) {
        return knots.tangents[knot];
    }
    return knots.tangents[knot] + (deformed.motionMm.col(static_cast<Eigen::Index>(after)) -
                                   deformed.motionMm.col(static_cast<Eigen::Index>(before))) /
                                      apart;
}

}   // namespace

std::vector<std::optional<KnotProjection>> projectKnots(const TreeKnots& knots, const DeformedTree& deformed,
                                                        const ProjectionContext& context)
{
    const RigidTransform viewFromPatient = context.cameraFromFirst * deformed.cameraFromPatient;
    const Eigen::Vector3d centroidInFirst = deformed.cameraFromPatient * context.centroidInPatient;
    const Eigen::Vector3d centroidInView = viewFromPatient * context.centroidInPatient;
    std::vector<std::optional<KnotProjection>> projections(knots.size());
    for (std::size_t branch = 0; branch + 1 < knots.firstOfBranch.size(); ++branch) {
        for (std::size_t k = knots.firstOfBranch[branch]; k < knots.firstOfBranch[branch + 1]; ++k) {
            const Eigen::Vector3d moved = knots.positions[k] + deformed.motionMm.col(static_cast<Eigen::Index>(k));
            const Eigen::Vector3d inView = viewFromPatient * moved;
            const auto pixel = project(context.camera, inView);
            if (knots.isUsed[k] == 0 || !pixel) {
                continue;
            }
            const double mmPerPx = millimetersPerPixel(context.camera, inView.z());
            const Eigen::Matrix<double, 2, 3> pixelByPlace = projectionJacobian(context.camera, inView);
            const Eigen::Vector2d seen =
                mmPerPx * pixelByPlace * (viewFromPatient.rotation * deformedTangent(knots, deformed, branch, k));
            if (seen.norm() < minSeenShare) {
                continue;
            }
            KnotProjection projection;
            projection.knot = k;
            projection.positionPx = *pixel;
            projection.normal = Eigen::Vector2d(-seen.y(), seen.x()).normalized();
            projection.mmPerPx = mmPerPx;
            projection.visibleMm = knots.lengthMm[k] * std::min(1.0, seen.norm());
            const Eigen::RowVector3d positionJacobian = mmPerPx * projection.normal.transpose() * pixelByPlace;
            const Eigen::RowVector3d byPlaceInFirst = positionJacobian * context.cameraFromFirst.rotation;
            projection.motionJacobian = (positionJacobian * viewFromPatient.rotation).transpose();
            projection.poseJacobian
                << (deformed.cameraFromPatient * moved - centroidInFirst).cross(byPlaceInFirst.transpose()),
                byPlaceInFirst.transpose();
            projection.geometryJacobian << (inView - centroidInView).cross(positionJacobian.transpose()),
                positionJacobian.transpose();
            projections[k] = projection;
        }
    }
    return projections;
}

}   // namespace angiopose::core

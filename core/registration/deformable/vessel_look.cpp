#include "core/registration/deformable/vessel_look.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double leastSeenShare = 0.25;   // of a vessel's length: what runs along the ray has no direction in the image

/// Tangent of the bent branch at a knot, patient axes; not unit.
Eigen::Vector3d bentTangent(const TreeKnots& knots, const BentTree& bent, std::size_t branch, std::size_t knot)
{
    const std::size_t before = std::max(knot, knots.firstOfBranch[branch] + 1) - 1;
    const std::size_t after = std::min(knot + 1, knots.firstOfBranch[branch + 1] - 1);
    const double apart = (knots.places[after] - knots.places[before]).norm();
    if (!(apart > 0.5)) {
        return knots.tangents[knot];
    }
    return knots.tangents[knot] + (bent.motionMm.col(static_cast<Eigen::Index>(after)) -
                                   bent.motionMm.col(static_cast<Eigen::Index>(before))) /
                                      apart;
}

}   // namespace

std::vector<std::optional<KnotLook>> lookAt(const TreeKnots& knots, const BentTree& bent, const DeformableSight& sight)
{
    const RigidTransform viewFromPatient = sight.cameraFromFirst * bent.cameraFromPatient;
    const Eigen::Vector3d centroidInFirst = bent.cameraFromPatient * sight.centroidInPatient;
    const Eigen::Vector3d centroidInView = viewFromPatient * sight.centroidInPatient;
    std::vector<std::optional<KnotLook>> looks(knots.size());
    for (std::size_t branch = 0; branch + 1 < knots.firstOfBranch.size(); ++branch) {
        for (std::size_t k = knots.firstOfBranch[branch]; k < knots.firstOfBranch[branch + 1]; ++k) {
            const Eigen::Vector3d moved = knots.places[k] + bent.motionMm.col(static_cast<Eigen::Index>(k));
            const Eigen::Vector3d inView = viewFromPatient * moved;
            const auto pixel = project(sight.camera, inView);
            if (knots.isUsed[k] == 0 || !pixel) {
                continue;
            }
            const double mmPerPx = millimetresPerPixel(sight.camera, inView.z());
            const Eigen::Matrix<double, 2, 3> pixelByPlace = projectionJacobian(sight.camera, inView);
            const Eigen::Vector2d seen =
                mmPerPx * pixelByPlace * (viewFromPatient.rotation * bentTangent(knots, bent, branch, k));
            if (seen.norm() < leastSeenShare) {
                continue;
            }
            KnotLook look;
            look.knot = k;
            look.placePx = *pixel;
            look.normal = Eigen::Vector2d(-seen.y(), seen.x()).normalized();
            look.mmPerPx = mmPerPx;
            look.seenMm = knots.lengthMm[k] * std::min(1.0, seen.norm());
            const Eigen::RowVector3d byPlace = mmPerPx * look.normal.transpose() * pixelByPlace;
            const Eigen::RowVector3d byPlaceInFirst = byPlace * sight.cameraFromFirst.rotation;
            look.byMotion = (byPlace * viewFromPatient.rotation).transpose();
            look.byPose << (bent.cameraFromPatient * moved - centroidInFirst).cross(byPlaceInFirst.transpose()),
                byPlaceInFirst.transpose();
            look.byGeometry << (inView - centroidInView).cross(byPlace.transpose()), byPlace.transpose();
            looks[k] = look;
        }
    }
    return looks;
}

}   // namespace angiopose::core

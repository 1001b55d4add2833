#include "tests/benchmark/known_partners.h"

#include <cmath>
#include <opencv2/calib3d.hpp>

namespace angiopose::benchmarks {

KnownPartners knownPartners(const core::Trial& trial)
{
    core::ProjectionCamera camera = trial.input.camera;
    camera.fx = std::abs(camera.fx);
    KnownPartners partners;
    partners.camera = {camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0};
    for (const core::VesselBranch& branch : trial.tree->branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            const auto pixel = core::project(camera, trial.trueCameraFromPatient * point);
            if (!pixel) {
                continue;
            }
            partners.points.emplace_back(point.x(), point.y(), point.z());
            partners.pixels.emplace_back(pixel->x(), pixel->y());
        }
    }
    const Eigen::Vector3d turn = core::logSo3(trial.input.initialCameraFromPatient.rotation);
    const Eigen::Vector3d& shift = trial.input.initialCameraFromPatient.translation;
    partners.startTurn = {turn.x(), turn.y(), turn.z()};
    partners.startShift = {shift.x(), shift.y(), shift.z()};
    return partners;
}

FoundPose refineLm(const KnownPartners& partners)
{
    FoundPose pose{partners.startTurn, partners.startShift};
    cv::solvePnPRefineLM(partners.points, partners.pixels, partners.camera, cv::noArray(), pose.turn, pose.shift);
    return pose;
}

FoundPose sqpnp(const KnownPartners& partners)
{
    FoundPose pose;
    cv::solvePnP(partners.points, partners.pixels, partners.camera, cv::noArray(), pose.turn, pose.shift, false,
                 cv::SOLVEPNP_SQPNP);
    return pose;
}

double meanDistancePx(const KnownPartners& partners, const FoundPose& pose)
{
    std::vector<cv::Point2d> found;
    cv::projectPoints(partners.points, pose.turn, pose.shift, partners.camera, cv::noArray(), found);
    double sum = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        sum += cv::norm(found[i] - partners.pixels[i]);
    }
    return sum / static_cast<double>(found.size());
}

}   // namespace angiopose::benchmarks

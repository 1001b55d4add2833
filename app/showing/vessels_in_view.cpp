#include "app/showing/vessels_in_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::app {

double depthOfTreeMm(const core::View& view, const core::Vessels& vessels)
{
    const double depth = (view.cameraFromPatient * core::centroidInPatient(*vessels.tree)).z();
    return std::max(depth, core::minProjectableDepthMm);
}

bool isOrientationKnown(const core::View& view, const core::Vessels& vessels)
{
    constexpr double farthestDeg = 45.0;
    core::View byAngles = view;
    byAngles.initialCameraFromPatient.reset();
    const auto expected = core::initialPoseOf(byAngles, vessels);
    if (!expected) {
        return false;
    }
    const Eigen::AngleAxisd turn(
        Eigen::Matrix3d(expected.value().rotation * view.cameraFromPatient.rotation.transpose()));
    return std::abs(turn.angle()) < farthestDeg * std::numbers::pi / 180.0;
}

}   // namespace angiopose::app

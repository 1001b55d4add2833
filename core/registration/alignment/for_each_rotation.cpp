#include "core/registration/alignment/for_each_rotation.h"

#include "core/geometry/angle_units.h"

#include <cmath>
#include <vector>

namespace angiopose::core {
namespace {

constexpr double tiltMargin = 1.2;   // factor by which the combined tilt about both axes may exceed the range

/// Returns angles −reach … reach in equal steps of about stepDeg, including 0; only 0 if the angle is locked; rad.
std::vector<double> anglesWithin(double reachDeg, const SearchRange& range, PoseAxis axis)
{
    const int half = range.freedom.isLocked(axis) ? 0 : static_cast<int>(std::ceil(reachDeg / range.stepDeg - 1e-9));
    std::vector<double> angles;
    for (int k = -half; k <= half; ++k) {
        angles.push_back(half == 0 ? 0.0 : reachDeg * k / half * radiansPerDegree);
    }
    return angles;
}

}   // namespace

void forEachRotation(const CentroidPose& start, const SearchRange& range,
                     const std::function<void(const CentroidPose&)>& visit,
                     const std::function<ObserverDecision(double)>& observe)
{
    const std::vector<double> tiltsX = anglesWithin(range.tiltDeg, range, PoseAxis::CraCau);
    const std::vector<double> tiltsY = anglesWithin(range.tiltDeg, range, PoseAxis::LaoRao);
    const std::vector<double> rolls = anglesWithin(range.rollDeg, range, PoseAxis::Roll);
    const double longestTilt = tiltMargin * range.tiltDeg * radiansPerDegree;
    double tiltsDone = 0.0;
    for (const double tiltX : tiltsX) {
        for (const double tiltY : tiltsY) {
            if (std::hypot(tiltX, tiltY) > longestTilt) {
                continue;
            }
            for (const double roll : rolls) {
                CentroidPose pose = start;
                pose.rotation = expSo3({0.0, 0.0, roll}) * expSo3({tiltX, tiltY, 0.0}) * start.rotation;
                visit(range.freedom.restoreLockedAxes(pose));
            }
        }
        tiltsDone += 1.0;
        if (observe(tiltsDone / static_cast<double>(tiltsX.size())) == ObserverDecision::Stop) {
            return;
        }
    }
}

}   // namespace angiopose::core

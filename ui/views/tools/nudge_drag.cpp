#include "ui/views/tools/nudge_drag.h"

#include <cmath>
#include <numbers>

namespace ui {
namespace {

constexpr double ringReachPx = 13.0;

}   // namespace

double screenAngleRad(const Eigen::Vector2d& centre, const Eigen::Vector2d& position)
{
    const Eigen::Vector2d ray = position - centre;
    return std::atan2(ray.y(), ray.x());
}

PoseHandle handleAt(const NudgeGrip& grip, const Eigen::Vector2d& position)
{
    if (!(grip.ringRadius > 0.0)) {
        return PoseHandle::None;
    }
    const double distance = (position - grip.centre).norm();
    return std::abs(distance - grip.ringRadius) <= ringReachPx ? PoseHandle::Roll : PoseHandle::Shift;
}

NudgeDrag::NudgeDrag(PoseHandle handle, const NudgeGrip& grip, const Eigen::Vector2d& start)
    : handle_(handle),
      centre_(grip.centre),
      mmPerPx_(grip.mmPerPx),
      last_(start),
      startRad_(screenAngleRad(grip.centre, start))
{
}

core::PoseOffset NudgeDrag::moveTo(const Eigen::Vector2d& position, double pace)
{
    core::PoseOffset offset;
    if (handle_ == PoseHandle::Roll) {
        const double turn = screenAngleRad(centre_, position) - screenAngleRad(centre_, last_);
        sweepRad_ += pace * std::remainder(turn, 2.0 * std::numbers::pi);
        offset.rollDeg = sweepRad_ * 180.0 / std::numbers::pi;
    } else {
        shiftPx_ += pace * (position - last_);
        offset.rightMm = shiftPx_.x() * mmPerPx_.x();
        offset.upMm = -shiftPx_.y() * mmPerPx_.y();
    }
    last_ = position;
    return offset;
}

}   // namespace ui

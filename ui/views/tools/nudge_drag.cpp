#include "ui/views/tools/nudge_drag.h"

#include <cmath>
#include <numbers>

namespace angiopose::ui {
namespace {

constexpr double ringReachPx = 13.0;
constexpr double depthPace = 4.0;   // depth barely changes the image, so a drag changes it four times as much

double outerRadius(const NudgeGrip& grip)
{
    return grip.ringRadius + outerHandleGapPx;
}

/// Returns the outer handle at the offset `fromCenter` (y down); None if there is none.
PoseHandle outerHandleAt(const NudgeGrip& grip, const Eigen::Vector2d& fromCenter)
{
    const double outer = outerRadius(grip);
    if (std::abs(fromCenter.x() + outer) <= ringReachPx &&
        std::abs(fromCenter.y()) <= outer * std::sin(outerHandleHalfRad)) {
        return PoseHandle::Depth;
    }
    if (std::abs(fromCenter.norm() - outer) > ringReachPx) {
        return PoseHandle::None;
    }
    const double angle = std::atan2(fromCenter.y(), fromCenter.x());
    return std::abs(angle) <= outerHandleHalfRad                            ? PoseHandle::CraCau
           : std::abs(angle - 0.5 * std::numbers::pi) <= outerHandleHalfRad ? PoseHandle::LaoRao
                                                                            : PoseHandle::None;
}

}   // namespace

double screenAngleRad(const Eigen::Vector2d& center, const Eigen::Vector2d& position)
{
    const Eigen::Vector2d ray = position - center;
    return std::atan2(ray.y(), ray.x());
}

PoseHandle handleAt(const NudgeGrip& grip, const Eigen::Vector2d& position)
{
    if (!(grip.ringRadius > 0.0)) {
        return PoseHandle::None;
    }
    const Eigen::Vector2d fromCenter = position - grip.center;
    if (std::abs(fromCenter.norm() - grip.ringRadius) <= ringReachPx) {
        return PoseHandle::Roll;
    }
    const PoseHandle outer = outerHandleAt(grip, fromCenter);
    return outer != PoseHandle::None ? outer : PoseHandle::Shift;
}

NudgeDrag::NudgeDrag(PoseHandle handle, const NudgeGrip& grip, const Eigen::Vector2d& start)
    : handle_(handle),
      center_(grip.center),
      mmPerPx_(grip.mmPerPx),
      degPerPx_(180.0 / std::numbers::pi / outerRadius(grip)),
      last_(start),
      startRad_(screenAngleRad(grip.center, start))
{
}

core::PoseOffset NudgeDrag::moveTo(const Eigen::Vector2d& position, double speedFactor)
{
    const double turn = screenAngleRad(center_, position) - screenAngleRad(center_, last_);
    sweepRad_ += speedFactor * std::remainder(turn, 2.0 * std::numbers::pi);
    shiftPx_ += speedFactor * (position - last_);
    last_ = position;
    core::PoseOffset offset;
    switch (handle_) {
        case PoseHandle::Roll:
            offset.rollDeg = sweepRad_ * 180.0 / std::numbers::pi;
            break;
        case PoseHandle::LaoRao:
            offset.laoRaoDeg = degPerPx_ * slidePx();
            break;
        case PoseHandle::CraCau:
            offset.craCauDeg = degPerPx_ * slidePx();
            break;
        case PoseHandle::Depth:
            offset.alongRayMm = depthPace * mmPerPx_.y() * slidePx();
            break;
        default:
            offset.rightMm = shiftPx_.x() * mmPerPx_.x();
            offset.upMm = -shiftPx_.y() * mmPerPx_.y();
    }
    return offset;
}

double NudgeDrag::slidePx() const
{
    return handle_ == PoseHandle::LaoRao ? shiftPx_.x() : -shiftPx_.y();
}

}   // namespace angiopose::ui

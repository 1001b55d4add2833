#include "ui/scenes/pose_handles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::ui {
namespace {

constexpr double crossArm = 0.32;   // as a fraction of the ring radius

Eigen::Vector2d directionOf(double angleRad)
{
    return {std::cos(angleRad), std::sin(angleRad)};
}

StrokeLine arc(const Eigen::Vector2d& center, double radius, double startRad, double sweepRad, const Color& color)
{
    StrokeLine line;
    const int steps = std::max(2, static_cast<int>(std::abs(sweepRad) * radius / 3.0));
    for (int k = 0; k <= steps; ++k) {
        line.push_back({center + radius * directionOf(startRad + sweepRad * k / steps), color});
    }
    return line;
}

StrokeLine arc(const PoseHandleState& state, double startRad, double sweepRad, const Color& color)
{
    return arc(state.center, state.radius, startRad, sweepRad, color);
}

void addWithShade(StrokeMesh& mesh, const StrokeLine& line, double widthPx)
{
    StrokeLine shade = line;
    for (StrokePoint& point : shade) {
        point.color = palette(ThemeMode::Dark).canvas;
    }
    addLine(mesh, shade, {widthPx + 2.0, 0.5, 2.0});
    addLine(mesh, line, {widthPx});
}

void addRing(StrokeMesh& mesh, const PoseHandleState& state)
{
    const Palette& colors = palette(ThemeMode::Dark);
    const bool isHot = state.hovered == PoseHandle::Roll || state.active == PoseHandle::Roll;
    const double width = (isHot ? 2.0 : 1.3) * state.pixelScale;
    const StrokeLine ring = arc(state, 0.0, 2.0 * std::numbers::pi, isHot ? colors.textStrong : colors.text);
    for (const StrokeLine& dash : splitIntoDashes(ring, {4.0 * state.pixelScale, 5.5 * state.pixelScale})) {
        addWithShade(mesh, dash, width);
    }
    if (state.active == PoseHandle::Roll) {
        addWithShade(mesh, arc(state, state.rollStartRad, state.rollSweepRad, colors.attention),
                     3.5 * state.pixelScale);
        const Eigen::Vector2d grip(std::cos(state.rollStartRad + state.rollSweepRad),
                                   std::sin(state.rollStartRad + state.rollSweepRad));
        addDot(mesh, {state.center + state.radius * grip, colors.attention}, 5.0 * state.pixelScale, 1.0);
    } else if (state.hovered == PoseHandle::Roll) {
        addWithShade(mesh, arc(state, state.rollStartRad - 0.22, 0.44, colors.attention), 3.0 * state.pixelScale);
    }
}

void addCross(StrokeMesh& mesh, const PoseHandleState& state)
{
    const Palette& colors = palette(ThemeMode::Dark);
    const bool isActive = state.active == PoseHandle::Shift;
    const Color tone = isActive ? colors.attention : colors.textStrong;
    const double arm = crossArm * state.radius;
    for (const Eigen::Vector2d& direction : {Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d(0.0, 1.0)}) {
        addWithShade(mesh, {{state.center - arm * direction, tone}, {state.center + arm * direction, tone}},
                     (isActive ? 2.2 : 1.3) * state.pixelScale);
    }
}

/// Adds a line with arrowheads at both ends, to indicate that the handle can be dragged in both directions.
void addDoubleArrow(StrokeMesh& mesh, const StrokeLine& shaft, double widthPx, double pixelScale)
{
    addWithShade(mesh, shaft, widthPx);
    const auto addHead = [&](const StrokePoint& tip, const StrokePoint& before) {
        const Eigen::Vector2d back = (before.at - tip.at).normalized();
        const Eigen::Vector2d side(-back.y(), back.x());
        const double length = 6.0 * pixelScale;
        addWithShade(mesh,
                     {{tip.at + length * (back + 0.7 * side), tip.color},
                      tip,
                      {tip.at + length * (back - 0.7 * side), tip.color}},
                     widthPx);
    };
    addHead(shaft.front(), shaft[1]);
    addHead(shaft.back(), shaft[shaft.size() - 2]);
}

/// Returns the shaft of an outer handle, starting at its left or lower end.
StrokeLine outerShaft(const PoseHandleState& state, PoseHandle handle, const Color& tone)
{
    constexpr double below = -0.5 * std::numbers::pi;
    const double radius = state.radius + outerHandleGapPx * state.pixelScale;
    if (handle == PoseHandle::Depth) {
        const double half = radius * std::sin(outerHandleHalfRad);
        return {{state.center + Eigen::Vector2d(-radius, -half), tone},
                {state.center + Eigen::Vector2d(-radius, half), tone}};
    }
    const double middle = handle == PoseHandle::LaoRao ? below : 0.0;
    return arc(state.center, radius, middle - outerHandleHalfRad, 2.0 * outerHandleHalfRad, tone);
}

/// Returns the position of the active handle's knob: at the center, displaced by the drag within the shaft.
Eigen::Vector2d knobOf(const PoseHandleState& state, PoseHandle handle)
{
    const double radius = state.radius + outerHandleGapPx * state.pixelScale;
    const double angle = std::clamp(state.slidePx / radius, -outerHandleHalfRad, outerHandleHalfRad);
    if (handle == PoseHandle::Depth) {
        return state.center + radius * Eigen::Vector2d(-1.0, std::sin(angle));
    }
    return state.center + radius * directionOf(handle == PoseHandle::LaoRao ? angle - 0.5 * std::numbers::pi : angle);
}

void addOuterHandles(StrokeMesh& mesh, const PoseHandleState& state)
{
    const Palette& colors = palette(ThemeMode::Dark);
    for (const PoseHandle handle : {PoseHandle::LaoRao, PoseHandle::CraCau, PoseHandle::Depth}) {
        const bool isActive = state.active == handle;
        const bool isHot = isActive || (state.hovered == handle && state.active == PoseHandle::None);
        const Color& tone = isHot ? colors.attention : colors.text;
        addDoubleArrow(mesh, outerShaft(state, handle, tone), (isHot ? 2.0 : 1.3) * state.pixelScale, state.pixelScale);
        if (isActive) {
            addDot(mesh, {knobOf(state, handle), colors.attention}, 5.0 * state.pixelScale, 1.0);
        }
    }
}

}   // namespace

StrokeMesh poseHandleStrokes(const PoseHandleState& state)
{
    StrokeMesh mesh;
    if (state.radius > 0.0) {
        addRing(mesh, state);
        addCross(mesh, state);
        addOuterHandles(mesh, state);
    }
    return mesh;
}

}   // namespace angiopose::ui

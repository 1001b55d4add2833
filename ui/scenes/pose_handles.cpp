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

StrokeLine arc(const PoseHandleLook& look, double startRad, double sweepRad, const Color& color)
{
    return arc(look.center, look.radius, startRad, sweepRad, color);
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

void addRing(StrokeMesh& mesh, const PoseHandleLook& look)
{
    const Palette& tones = palette(ThemeMode::Dark);
    const bool isHot = look.hot == PoseHandle::Roll || look.active == PoseHandle::Roll;
    const double width = (isHot ? 2.0 : 1.3) * look.pixelScale;
    const StrokeLine ring = arc(look, 0.0, 2.0 * std::numbers::pi, isHot ? tones.textStrong : tones.text);
    for (const StrokeLine& dash : dashed(ring, {4.0 * look.pixelScale, 5.5 * look.pixelScale})) {
        addWithShade(mesh, dash, width);
    }
    if (look.active == PoseHandle::Roll) {
        addWithShade(mesh, arc(look, look.rollStartRad, look.rollSweepRad, tones.attention), 3.5 * look.pixelScale);
        const Eigen::Vector2d grip(std::cos(look.rollStartRad + look.rollSweepRad),
                                   std::sin(look.rollStartRad + look.rollSweepRad));
        addDot(mesh, {look.center + look.radius * grip, tones.attention}, 5.0 * look.pixelScale, 1.0);
    } else if (look.hot == PoseHandle::Roll) {
        addWithShade(mesh, arc(look, look.rollStartRad - 0.22, 0.44, tones.attention), 3.0 * look.pixelScale);
    }
}

void addCross(StrokeMesh& mesh, const PoseHandleLook& look)
{
    const Palette& tones = palette(ThemeMode::Dark);
    const bool isActive = look.active == PoseHandle::Shift;
    const Color tone = isActive ? tones.attention : tones.textStrong;
    const double arm = crossArm * look.radius;
    for (const Eigen::Vector2d& direction : {Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d(0.0, 1.0)}) {
        addWithShade(mesh, {{look.center - arm * direction, tone}, {look.center + arm * direction, tone}},
                     (isActive ? 2.2 : 1.3) * look.pixelScale);
    }
}

/// Adds a line with arrowheads at both ends, which indicates that the handle can be dragged in both directions.
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

/// Returns the shaft of an outer handle, from its left or lower end.
StrokeLine outerShaft(const PoseHandleLook& look, PoseHandle handle, const Color& tone)
{
    constexpr double below = -0.5 * std::numbers::pi;
    const double radius = look.radius + outerHandleGapPx * look.pixelScale;
    if (handle == PoseHandle::Depth) {
        const double half = radius * std::sin(outerHandleHalfRad);
        return {{look.center + Eigen::Vector2d(-radius, -half), tone},
                {look.center + Eigen::Vector2d(-radius, half), tone}};
    }
    const double middle = handle == PoseHandle::LaoRao ? below : 0.0;
    return arc(look.center, radius, middle - outerHandleHalfRad, 2.0 * outerHandleHalfRad, tone);
}

/// Position of the knob of the active handle: at the center, moved by the drag within the shaft.
Eigen::Vector2d knobOf(const PoseHandleLook& look, PoseHandle handle)
{
    const double radius = look.radius + outerHandleGapPx * look.pixelScale;
    const double angle = std::clamp(look.slidePx / radius, -outerHandleHalfRad, outerHandleHalfRad);
    if (handle == PoseHandle::Depth) {
        return look.center + radius * Eigen::Vector2d(-1.0, std::sin(angle));
    }
    return look.center + radius * directionOf(handle == PoseHandle::LaoRao ? angle - 0.5 * std::numbers::pi : angle);
}

void addOuterHandles(StrokeMesh& mesh, const PoseHandleLook& look)
{
    const Palette& tones = palette(ThemeMode::Dark);
    for (const PoseHandle handle : {PoseHandle::LaoRao, PoseHandle::CraCau, PoseHandle::Depth}) {
        const bool isActive = look.active == handle;
        const bool isHot = isActive || (look.hot == handle && look.active == PoseHandle::None);
        const Color& tone = isHot ? tones.attention : tones.text;
        addDoubleArrow(mesh, outerShaft(look, handle, tone), (isHot ? 2.0 : 1.3) * look.pixelScale, look.pixelScale);
        if (isActive) {
            addDot(mesh, {knobOf(look, handle), tones.attention}, 5.0 * look.pixelScale, 1.0);
        }
    }
}

}   // namespace

StrokeMesh poseHandleStrokes(const PoseHandleLook& look)
{
    StrokeMesh mesh;
    if (look.radius > 0.0) {
        addRing(mesh, look);
        addCross(mesh, look);
        addOuterHandles(mesh, look);
    }
    return mesh;
}

}   // namespace angiopose::ui

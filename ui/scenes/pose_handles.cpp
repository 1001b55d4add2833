#include "ui/scenes/pose_handles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ui {
namespace {

constexpr double crossArm = 0.32;   // of the ring's radius

StrokeLine arc(const PoseHandleLook& look, double startRad, double sweepRad, const Color& color)
{
    StrokeLine line;
    const int steps = std::max(2, static_cast<int>(std::abs(sweepRad) * look.radius / 3.0));
    for (int k = 0; k <= steps; ++k) {
        const double angle = startRad + sweepRad * k / steps;
        line.push_back({look.centre + look.radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)), color});
    }
    return line;
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
        addDot(mesh, {look.centre + look.radius * grip, tones.attention}, 5.0 * look.pixelScale, 1.0);
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
        addWithShade(mesh, {{look.centre - arm * direction, tone}, {look.centre + arm * direction, tone}},
                     (isActive ? 2.2 : 1.3) * look.pixelScale);
    }
}

}   // namespace

StrokeMesh poseHandleStrokes(const PoseHandleLook& look)
{
    StrokeMesh mesh;
    if (look.radius > 0.0) {
        addRing(mesh, look);
        addCross(mesh, look);
    }
    return mesh;
}

}   // namespace ui

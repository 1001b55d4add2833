#include "ui/scenes/beam.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace angiopose::ui {
namespace {

/// Returns the segments of a line inside the view; in a zoomed view, a line can be many thousands of px long.
std::vector<StrokeLine> visibleParts(const StrokeLine& line, const BeamStyle& style)
{
    const Eigen::Vector2d margin = Eigen::Vector2d::Constant(16.0 * style.pixelScale);
    return clipLine(line, -margin, style.sizePx + margin);
}

/// Returns the visible dashes of `line`. The pattern starts at the beginning of the line, so that the dashes stay fixed
/// when the view moves.
std::vector<StrokeLine> visibleDashes(const StrokeLine& line, const DashPattern& pattern, const BeamStyle& style)
{
    std::vector<StrokeLine> dashes;
    for (StrokeLine& part : visibleParts(line, style)) {
        const Eigen::Vector2d offset = part.front().at - line.front().at;
        const double sinceDashPx = std::fmod(offset.norm(), pattern.dashPx + pattern.gapPx);
        part.front().at -= sinceDashPx * offset.stableNormalized();
        std::ranges::move(splitIntoDashes(part, pattern), std::back_inserter(dashes));
    }
    return dashes;
}

}   // namespace

Eigen::Matrix4d Beam::patientFromImagePlane() const
{
    // A pixel (u, v) lies on the detector plane Z = SID at X = (u − cx) SID / fx, Y = (v − cy) SID / fy.
    Eigen::Matrix4d cameraFromImage = Eigen::Matrix4d::Identity();
    cameraFromImage(0, 0) = sourceToDetectorMm / camera.fx;
    cameraFromImage(1, 1) = sourceToDetectorMm / camera.fy;
    cameraFromImage(0, 3) = -camera.cx * sourceToDetectorMm / camera.fx;
    cameraFromImage(1, 3) = -camera.cy * sourceToDetectorMm / camera.fy;
    cameraFromImage(2, 3) = sourceToDetectorMm;
    return patientFromCamera.matrix() * cameraFromImage;
}

std::array<Eigen::Vector3d, 4> Beam::detectorCorners() const
{
    const Eigen::Matrix4d patientFromImage = patientFromImagePlane();
    const double right = camera.width - 0.5;
    const double bottom = camera.height - 0.5;
    const auto corner = [&patientFromImage](double u, double v) {
        return Eigen::Vector3d((patientFromImage * Eigen::Vector4d(u, v, 0.0, 1.0)).head<3>());
    };
    return {corner(-0.5, -0.5), corner(right, -0.5), corner(right, bottom), corner(-0.5, bottom)};
}

void addBeamStrokes(StrokeMesh& mesh, const Beam& beam, const ScreenFromPatient& toScreen, const BeamStyle& style)
{
    if (!beam.hasDetector()) {
        return;
    }
    const double scale = style.pixelScale;
    const Eigen::Vector2d source = toScreen * beam.source();
    const Color faint = mixed(style.colors.field, style.colors.label, 0.45);
    const Color edge = mixed(style.colors.field, style.colors.label, 0.7);
    StrokeLine border;
    for (const Eigen::Vector3d& corner : beam.detectorCorners()) {
        const Eigen::Vector2d at = toScreen * corner;
        border.push_back({at, edge});
        for (const StrokeLine& dash :
             visibleDashes({{source, faint}, {at, faint}}, {3.0 * scale, 4.0 * scale}, style)) {
            addLine(mesh, dash, {1.0 * scale});
        }
    }
    border.push_back(border.front());
    for (const StrokeLine& part : visibleParts(border, style)) {
        addLine(mesh, part, {1.2 * scale});
    }
    addLine(mesh, {{source, style.colors.attention}}, {9.0 * scale, 0.35, 9.0 * scale});
    addDot(mesh, {source, style.colors.attention}, 3.5 * scale, 1.0);
}

}   // namespace angiopose::ui

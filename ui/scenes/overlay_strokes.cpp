#include "ui/scenes/overlay_strokes.h"

#include "ui/scenes/branch_style.h"
#include "ui/scenes/overlay_pens.h"
#include "ui/scenes/point_colors.h"

#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

constexpr double clipMarginPx = 64.0;
constexpr double farPx = 4e4;   // dashes extend beyond the view so that adjacent tiles match

/// Lines that draw a branch, its centerline or its two edges, in device px.
struct BranchLines {
    const ProjectedBranch* source;
    BranchStyle style;
    std::vector<StrokeLine> lines;
    std::vector<StrokePoint> ends;
};

struct Box {
    Eigen::Vector2d lower;
    Eigen::Vector2d upper;
};

Box boxAround(const DeviceFromImage& device, double marginPx)
{
    const Eigen::Vector2d margin = Eigen::Vector2d::Constant(marginPx);
    return {-margin, Eigen::Vector2d(device.width, device.height) + margin};
}

/// Returns the left (+1) or right (−1) edge of the vessel, or its centerline (0).
StrokeLine edgeOf(const std::vector<ProjectedPoint>& run, const DeviceFromImage& device, const PointColors& tones,
                  double side)
{
    StrokeLine line;
    line.reserve(run.size());
    for (const ProjectedPoint& point : run) {
        line.push_back({device * point.edgePx(side), tones(point)});
    }
    return line;
}

bool hasRadius(const std::vector<ProjectedPoint>& run)
{
    return std::any_of(run.begin(), run.end(), [](const ProjectedPoint& point) { return point.radiusPx > 0.0; });
}

void append(std::vector<StrokeLine>& to, std::vector<StrokeLine> from)
{
    std::move(from.begin(), from.end(), std::back_inserter(to));
}

std::vector<StrokeLine> visibleParts(const StrokeLine& line, LinePattern pattern, const DeviceFromImage& device,
                                     double lineWidthPx)
{
    const Box near = boxAround(device, clipMarginPx);
    if (pattern == LinePattern::Solid) {
        return clipLine(line, near.lower, near.upper);
    }
    const Box far = boxAround(device, farPx);
    const DashPattern dashes{branchDashes[0] * lineWidthPx, branchDashes[1] * lineWidthPx};
    std::vector<StrokeLine> parts;
    for (const StrokeLine& part : clipLine(line, far.lower, far.upper)) {
        for (const StrokeLine& dash : splitIntoDashes(part, dashes)) {
            append(parts, clipLine(dash, near.lower, near.upper));
        }
    }
    return parts;
}

BranchLines linesOf(const ProjectedBranch& branch, const OverlayContent& content, const DeviceFromImage& device)
{
    BranchLines result{&branch, branchStyle(branch.id, content.marks), {}, {}};
    const PointColors tones(content, branch.id, result.style.color);
    for (const auto& run : branch.runs) {
        const bool asOutline = content.mode != OverlayMode::Centerline && hasRadius(run);
        for (const double side : asOutline ? std::vector<double>{1.0, -1.0} : std::vector<double>{0.0}) {
            const StrokeLine line = edgeOf(run, device, tones, side);
            append(result.lines, visibleParts(line, result.style.pattern, device, content.lineWidthPx));
        }
        if (result.style.hasEndDots && !asOutline) {
            result.ends.push_back({device * run.front().px, tones(run.front())});
            result.ends.push_back({device * run.back().px, tones(run.back())});
        }
    }
    return result;
}

StrokeLine inOneColor(StrokeLine line, const Color& color)
{
    for (StrokePoint& point : line) {
        point.color = color;
    }
    return line;
}

void addTraced(StrokeMesh& mesh, const OverlayContent& content, const DeviceFromImage& device)
{
    const Palette& tones = palette(ThemeMode::Dark);
    const double width = tracedWidth * content.lineWidthPx;
    const Box near = boxAround(device, clipMarginPx);
    const Box far = boxAround(device, farPx);
    for (const core::Curve2d& curve : content.traced.curves) {
        StrokeLine line;
        for (const Eigen::Vector2d& point : curve.pointsPx) {
            line.push_back({device * point, tones.fine});
        }
        for (const StrokeLine& part : clipLine(line, far.lower, far.upper)) {
            for (const StrokeLine& dot : splitIntoDashes(part, {tracedDots[0] * width, tracedDots[1] * width})) {
                for (const StrokeLine& shown : clipLine(dot, near.lower, near.upper)) {
                    addLine(mesh, inOneColor(shown, tones.canvas),
                            {width + tracedShadePx, tracedShadeOpacity, tracedShadePx});
                    addLine(mesh, shown, {width, 1.0});
                }
            }
        }
    }
}

void addGlow(StrokeMesh& mesh, const BranchLines& branch, double widthPx)
{
    if (branch.style.glow == Glow::None) {
        return;
    }
    const double opacity = glowOpacity(branch.style.glow);
    for (const StrokeLine& line : branch.lines) {
        addLine(mesh, inOneColor(line, branch.style.color), {glowWidth * widthPx, opacity, glowFade * widthPx});
    }
}

void addHalo(StrokeMesh& mesh, const BranchLines& branch, double widthPx, double lineWidthPx)
{
    const Color shade = palette(ThemeMode::Dark).canvas;
    for (const StrokeLine& line : branch.lines) {
        addLine(mesh, inOneColor(line, shade),
                {widthPx + haloWidth * lineWidthPx, haloOpacity * branch.style.opacity, haloFadePx});
    }
}

void addCore(StrokeMesh& mesh, const BranchLines& branch, double widthPx)
{
    for (const StrokeLine& line : branch.lines) {
        addLine(mesh, line, {widthPx, branch.style.opacity});
    }
    for (const StrokePoint& end : branch.ends) {
        addDot(mesh, end, endDotRadius * widthPx, branch.style.opacity);
    }
}

/// Adds the translucent interior of the vessels, below all lines.
void addTubes(StrokeMesh& mesh, const std::vector<BranchLines>& branches, const OverlayContent& content,
              const DeviceFromImage& device)
{
    for (const BranchLines& branch : branches) {
        const BranchStyle& style = branch.style;
        const PointColors tones(content, branch.source->id, style.color);
        for (const auto& run : branch.source->runs) {
            if (hasRadius(run)) {
                addRibbon(mesh, edgeOf(run, device, tones, 1.0), edgeOf(run, device, tones, -1.0),
                          insideOpacity * style.opacity);
            }
        }
    }
}

void fade(StrokeMesh& mesh, double opacity)
{
    for (std::size_t i = 3; i < mesh.colors.size(); i += 4) {
        mesh.colors[i] = static_cast<std::uint8_t>(std::lround(opacity * mesh.colors[i]));
    }
    for (std::size_t i = 0; mesh.shapes && i < mesh.shapes->size(); ++i) {
        (*mesh.shapes)[i].pen.opacity *= opacity;
    }
}

void addOverlay(StrokeMesh& mesh, const OverlayContent& content, const DeviceFromImage& device)
{
    if (content.isOverlayHidden) {
        return;
    }
    if (content.mode != OverlayMode::Hidden) {
        std::vector<BranchLines> branches;
        branches.reserve(content.projected.size());
        for (const ProjectedBranch& branch : content.projected) {
            branches.push_back(linesOf(branch, content, device));
        }
        std::stable_sort(branches.begin(), branches.end(),
                         [](const BranchLines& a, const BranchLines& b) { return a.style.zOrder < b.style.zOrder; });
        const double modeFactor = content.mode == OverlayMode::Centerline ? 1.0 : edgeWidth;
        const auto widthOf = [&](const BranchLines& branch) {
            return modeFactor * branch.style.widthFactor * content.lineWidthPx;
        };
        if (content.mode == OverlayMode::Tube) {
            addTubes(mesh, branches, content, device);
        }
        // Draw the dark borders of all branches first; otherwise, they would cut into other branches at bifurcations.
        for (const BranchLines& branch : branches) {
            addGlow(mesh, branch, widthOf(branch));
        }
        for (const BranchLines& branch : branches) {
            addHalo(mesh, branch, widthOf(branch), content.lineWidthPx);
        }
        for (const BranchLines& branch : branches) {
            addCore(mesh, branch, widthOf(branch));
        }
        fade(mesh, content.opacity);
    }
    if (content.isTracedShown) {
        addTraced(mesh, content, device);
    }
}

}   // namespace

Eigen::Vector2d DeviceFromImage::operator*(const Eigen::Vector2d& imagePoint) const
{
    return {(imagePoint.x() - rect.left) / (rect.right - rect.left) * width,
            (rect.bottom - imagePoint.y()) / (rect.bottom - rect.top) * height};
}

StrokeMesh overlayStrokes(const OverlayContent& content, const DeviceFromImage& device)
{
    StrokeMesh mesh;
    addOverlay(mesh, content, device);
    return mesh;
}

std::vector<StrokeShape> overlayShapes(const OverlayContent& content, const DeviceFromImage& device)
{
    std::vector<StrokeShape> shapes;
    StrokeMesh mesh;
    mesh.shapes = &shapes;
    addOverlay(mesh, content, device);
    return shapes;
}

}   // namespace angiopose::ui

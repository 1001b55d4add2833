#include "ui/scenes/overlay_strokes.h"

#include "ui/scenes/branch_style.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace angiopose::ui {
namespace {

constexpr double strokeThinningPx = 0.75;   // finer detail does not show
constexpr double clipMarginPx = 64.0;
constexpr double farPx = 4e4;   // dashes are laid out this far beyond the picture, so that neighbouring tiles agree

/// One branch ready to be drawn: its centreline or its two edges, in device px.
struct BranchLines {
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

Color residualTone(double residualPx, double maximumPx)
{
    return residualPx > maximumPx ? residualColorAboveScale() : residualColor(residualPx / maximumPx);
}

/// Near points towards white, far points towards the canvas.
Color withDepth(const Color& color, double depthMm, const DepthRange& range)
{
    const Palette& tones = palette(ThemeMode::Dark);
    const double spanMm = std::max(1.0, range.farMm - range.nearMm);
    const double farness = std::clamp((depthMm - range.nearMm) / spanMm, 0.0, 1.0);
    return farness < 0.5 ? mixed(tones.textStrong, color, 0.3 + 1.4 * farness)
                         : mixed(color, tones.canvas, 1.5 * (farness - 0.5));
}

/// Colour of every point of one branch.
class PointColors {
public:
    PointColors(const OverlayContent& content, int branchId, const Color& plain)
        : plain_(plain), depth_(content.depthCue == DepthCue::None ? std::nullopt : std::optional(content.depthRange))
    {
        const auto found = content.residualPx.find(branchId);
        if (content.scaleMaximumPx > 0.0 && found != content.residualPx.end()) {
            residualPx_ = &found->second;
            maximumPx_ = content.scaleMaximumPx;
        }
    }
    Color operator()(const ProjectedPoint& point) const
    {
        if (depth_) {
            return withDepth(plain_, point.depthMm, *depth_);
        }
        const bool isKnown =
            residualPx_ && point.index < residualPx_->size() && std::isfinite((*residualPx_)[point.index]);
        return isKnown ? residualTone((*residualPx_)[point.index], maximumPx_) : plain_;
    }

private:
    Color plain_;
    std::optional<DepthRange> depth_;   ///< instead of residuals
    const std::vector<double>* residualPx_ = nullptr;
    double maximumPx_ = 0.0;
};

StrokeLine centreOf(const std::vector<ProjectedPoint>& run, const DeviceFromImage& device, const PointColors& colors)
{
    StrokeLine line;
    line.reserve(run.size());
    for (const ProjectedPoint& point : run) {
        line.push_back({device * point.px, colors(point)});
    }
    return line;
}

/// The vessel's edge: the centreline moved sideways by its radius, to the left (+1) or right (−1).
StrokeLine edgeOf(const std::vector<ProjectedPoint>& run, const DeviceFromImage& device, const PointColors& colors,
                  double side)
{
    std::vector<Eigen::Vector2d> centre;
    centre.reserve(run.size());
    for (const ProjectedPoint& point : run) {
        centre.push_back(point.px);
    }
    const std::vector<Eigen::Vector2d> tangents = core::tangentsOf(centre, 3);
    StrokeLine line;
    line.reserve(run.size());
    for (std::size_t i = 0; i < run.size(); ++i) {
        const Eigen::Vector2d normal(-tangents[i].y(), tangents[i].x());
        line.push_back({device * (run[i].px + side * run[i].radiusPx * normal), colors(run[i])});
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
    const StrokeLine simple = thinned(line, strokeThinningPx);
    if (pattern == LinePattern::Solid) {
        return clipped(simple, near.lower, near.upper);
    }
    const Box far = boxAround(device, farPx);
    const DashPattern dashes{3.5 * lineWidthPx, 3.0 * lineWidthPx};
    std::vector<StrokeLine> parts;
    for (const StrokeLine& part : clipped(simple, far.lower, far.upper)) {
        for (const StrokeLine& dash : dashed(part, dashes)) {
            append(parts, clipped(dash, near.lower, near.upper));
        }
    }
    return parts;
}

BranchLines linesOf(const ProjectedBranch& branch, const OverlayContent& content, const DeviceFromImage& device)
{
    BranchLines result{branchStyle(branch.id, content.marks), {}, {}};
    const PointColors colors(content, branch.id, result.style.color);
    for (const auto& run : branch.runs) {
        const bool asOutline = content.mode != OverlayMode::Centerline && hasRadius(run);
        for (const double side : asOutline ? std::vector<double>{1.0, -1.0} : std::vector<double>{0.0}) {
            const StrokeLine line = asOutline ? edgeOf(run, device, colors, side) : centreOf(run, device, colors);
            append(result.lines, visibleParts(line, result.style.pattern, device, content.lineWidthPx));
        }
        if (result.style.hasEndDots && !asOutline) {
            result.ends.push_back({device * run.front().px, colors(run.front())});
            result.ends.push_back({device * run.back().px, colors(run.back())});
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
    const double width = 0.85 * content.lineWidthPx;
    const Box near = boxAround(device, clipMarginPx);
    const Box far = boxAround(device, farPx);
    for (const core::Curve2d& curve : content.traced.curves) {
        StrokeLine line;
        for (const Eigen::Vector2d& point : curve.pointsPx) {
            line.push_back({device * point, tones.fine});
        }
        for (const StrokeLine& part : clipped(thinned(line, strokeThinningPx), far.lower, far.upper)) {
            for (const StrokeLine& dot : dashed(part, {0.1 * width, 2.6 * width})) {
                for (const StrokeLine& shown : clipped(dot, near.lower, near.upper)) {
                    addLine(mesh, inOneColor(shown, tones.canvas), {width + 1.5, 0.6, 1.5});
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
    const double opacity = branch.style.glow == Glow::Strong ? 0.55 : 0.3;
    for (const StrokeLine& line : branch.lines) {
        addLine(mesh, inOneColor(line, branch.style.color), {3.0 * widthPx, opacity, 4.0 * widthPx});
    }
}

void addHalo(StrokeMesh& mesh, const BranchLines& branch, double widthPx, double lineWidthPx)
{
    const Color shade = palette(ThemeMode::Dark).canvas;
    for (const StrokeLine& line : branch.lines) {
        addLine(mesh, inOneColor(line, shade), {widthPx + 1.1 * lineWidthPx, 0.65 * branch.style.opacity, 1.5});
    }
}

void addCore(StrokeMesh& mesh, const BranchLines& branch, double widthPx)
{
    for (const StrokeLine& line : branch.lines) {
        addLine(mesh, line, {widthPx, branch.style.opacity});
    }
    for (const StrokePoint& end : branch.ends) {
        addDot(mesh, end, 1.15 * widthPx, branch.style.opacity);
    }
}

/// The vessels' insides, translucent, below all lines.
void addTubes(StrokeMesh& mesh, const OverlayContent& content, const DeviceFromImage& device)
{
    constexpr double inside = 0.32;
    for (const ProjectedBranch& branch : content.tree) {
        const BranchStyle style = branchStyle(branch.id, content.marks);
        const PointColors colors(content, branch.id, style.color);
        for (const auto& run : branch.runs) {
            if (hasRadius(run)) {
                addRibbon(mesh, edgeOf(run, device, colors, 1.0), edgeOf(run, device, colors, -1.0),
                          inside * style.opacity);
            }
        }
    }
}

void fade(StrokeMesh& mesh, double opacity)
{
    for (std::size_t i = 3; i < mesh.colors.size(); i += 4) {
        mesh.colors[i] = static_cast<std::uint8_t>(std::lround(opacity * mesh.colors[i]));
    }
}

}   // namespace

DepthRange depthRangeOf(const ProjectedTree& tree)
{
    DepthRange range{1e30, -1e30};
    for (const ProjectedBranch& branch : tree) {
        for (const auto& run : branch.runs) {
            for (const ProjectedPoint& point : run) {
                range.nearMm = std::min(range.nearMm, point.depthMm);
                range.farMm = std::max(range.farMm, point.depthMm);
            }
        }
    }
    return range;
}

Eigen::Vector2d DeviceFromImage::operator*(const Eigen::Vector2d& imagePoint) const
{
    return {(imagePoint.x() - rect.left) / (rect.right - rect.left) * width,
            (rect.bottom - imagePoint.y()) / (rect.bottom - rect.top) * height};
}

StrokeMesh overlayStrokes(const OverlayContent& content, const DeviceFromImage& device)
{
    StrokeMesh mesh;
    if (content.isVeiled) {
        return mesh;
    }
    if (content.mode != OverlayMode::Hidden) {
        std::vector<BranchLines> branches;
        branches.reserve(content.tree.size());
        for (const ProjectedBranch& branch : content.tree) {
            branches.push_back(linesOf(branch, content, device));
        }
        std::stable_sort(branches.begin(), branches.end(),
                         [](const BranchLines& a, const BranchLines& b) { return a.style.rank < b.style.rank; });
        const double modeFactor = content.mode == OverlayMode::Centerline ? 1.0 : 0.7;
        const auto widthOf = [&](const BranchLines& branch) {
            return modeFactor * branch.style.widthFactor * content.lineWidthPx;
        };
        if (content.mode == OverlayMode::Tube) {
            addTubes(mesh, content, device);
        }
        // All dark borders first: at a bifurcation no branch may cut into its neighbour.
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
    return mesh;
}

}   // namespace angiopose::ui
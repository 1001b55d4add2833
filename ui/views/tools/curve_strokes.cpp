#include "ui/views/tools/curve_strokes.h"

#include "ui/theme/theme.h"

#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr double curveThinningPx = 0.7;
constexpr double marginPx = 64.0;   ///< clipping margin around the image, wider than any stroke
constexpr double dashAt100Px = 7.0;

const Palette& colors()
{
    return palette(ThemeMode::Dark);
}

/// Returns the parts of a line that may be visible.
std::vector<StrokeLine> onPicture(const CurveCanvas& canvas, const StrokeLine& line)
{
    const Eigen::Vector2d margin(marginPx, marginPx);
    const Eigen::Vector2d size(canvas.widthPx, canvas.heightPx);
    const bool isWhole = std::ranges::all_of(line, [&](const StrokePoint& point) {
        return (point.at.array() >= -marginPx).all() && (point.at.array() <= (size + margin).array()).all();
    });
    return isWhole ? std::vector<StrokeLine>{line} : clipLine(line, -margin, size + margin);
}

void addStroke(StrokeMesh& mesh, const StrokeLine& line, double widthPx, double opacity)
{
    StrokeLine shade = line;
    for (StrokePoint& point : shade) {
        point.color = colors().canvas;
    }
    addLine(mesh, shade, {widthPx + 2.0, 0.55 * opacity, 1.5});
    addLine(mesh, line, {widthPx, opacity});
}

void addFaint(StrokeMesh& mesh, const CurveCanvas& canvas, const core::Curve2d& curve, double widthPx)
{
    for (const StrokeLine& part : onPicture(canvas, lineOn(canvas, curve.pointsPx, colors().hint))) {
        addLine(mesh, part, {widthPx, 0.6});
    }
}

bool holds(const std::vector<int>& ids, int id)
{
    return std::ranges::find(ids, id) != ids.end();
}

}   // namespace

bool CurveCanvas::isSame(const CurveCanvas& other) const
{
    return canvasFromImage.matrix() == other.canvasFromImage.matrix() && widthPx == other.widthPx &&
           heightPx == other.heightPx && pixelRatio == other.pixelRatio;
}

StrokeLine lineOn(const CurveCanvas& canvas, const std::vector<Eigen::Vector2d>& pointsPx, const Color& tone)
{
    StrokeLine line;
    line.reserve(pointsPx.size());
    for (const Eigen::Vector2d& point : pointsPx) {
        line.push_back({canvas.canvasFromImage * point, tone});
    }
    return thinLine(line, curveThinningPx);
}

void addShadowed(StrokeMesh& mesh, const CurveCanvas& canvas, const StrokeLine& line, double widthPx, double opacity)
{
    for (const StrokeLine& part : onPicture(canvas, line)) {
        addStroke(mesh, part, widthPx, opacity);
    }
}

void addShadowedDashes(StrokeMesh& mesh, const CurveCanvas& canvas, const StrokeLine& line, double widthPx,
                       double dashPx)
{
    for (const StrokeLine& part : onPicture(canvas, line)) {
        for (const StrokeLine& dash : splitIntoDashes(part, {dashPx, dashPx})) {
            addStroke(mesh, dash, widthPx, 1.0);
        }
    }
}

void addCurves(StrokeMesh& mesh, const CurveCanvas& canvas, const core::Centerline2d& curves, const CurveStyle& style)
{
    const double width = style.widthPx * canvas.pixelRatio;
    for (const core::Curve2d& curve : curves.curves) {
        if (style.isFaint) {
            addFaint(mesh, canvas, curve, width);
        } else if (holds(style.deviceIds, curve.id) || holds(style.suspectIds, curve.id)) {
            const Color& tone = holds(style.deviceIds, curve.id) ? colors().textStrong : colors().attention;
            addShadowedDashes(mesh, canvas, lineOn(canvas, curve.pointsPx, tone), width,
                              dashAt100Px * canvas.pixelRatio);
        } else {
            addShadowed(mesh, canvas, lineOn(canvas, curve.pointsPx, colors().accent), width, 1.0);
        }
    }
}

const StrokeMesh& CurveStrokeCache::of(int revision, const CurveCanvas& canvas, const core::Centerline2d& curves,
                                       const CurveStyle& style)
{
    if (!entry_ || entry_->revision != revision || !entry_->canvas.isSame(canvas)) {
        entry_ = Entry{revision, canvas, {}};
        addCurves(entry_->mesh, canvas, curves, style);
    }
    return entry_->mesh;
}

}   // namespace angiopose::ui

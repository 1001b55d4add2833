// What EditCurvesTool draws: curves, brush, region, path under way.
#include "core/tracing/angiogram/drawing/edit_centerline.h"
#include "ui/theme/active_theme.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tools/edit_curves_tool.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace angiopose::ui {
namespace {

constexpr double curveThinningPx = 0.7;
constexpr double curveWidth = 2.2;   ///< px at 100 %

const Palette& curveTones()
{
    return palette(ThemeMode::Dark);
}

void addShadowedLine(StrokeMesh& mesh, const StrokeLine& line, double widthPx, double opacity)
{
    StrokeLine shade = line;
    for (StrokePoint& point : shade) {
        point.color = curveTones().canvas;
    }
    addLine(mesh, shade, {widthPx + 2.0, 0.55 * opacity, 1.5});
    addLine(mesh, line, {widthPx, opacity});
}

void addDashes(StrokeMesh& mesh, const StrokeLine& line, double widthPx, double dashPx)
{
    for (const StrokeLine& part : dashed(line, {dashPx, dashPx})) {
        addShadowedLine(mesh, part, widthPx, 1.0);
    }
}

Eigen::Vector2d nearestPoint(const core::Centerline2d& curves, int id, const Eigen::Vector2d& to)
{
    Eigen::Vector2d nearest = to;
    double shortest = std::numeric_limits<double>::max();
    for (const core::Curve2d& curve : curves.curves) {
        for (const Eigen::Vector2d& point : curve.pointsPx) {
            if (curve.id == id && (point - to).norm() < shortest) {
                shortest = (point - to).norm();
                nearest = point;
            }
        }
    }
    return nearest;
}

}   // namespace

Eigen::Vector2d EditCurvesTool::onCanvas(const Eigen::Vector2d& imagePx, int heightPx) const
{
    const QPointF at = view().widgetFromImage(imagePx) * view().devicePixelRatio();
    return {at.x(), heightPx - at.y()};
}

StrokeLine EditCurvesTool::lineOnCanvas(const std::vector<Eigen::Vector2d>& points, const Color& tone,
                                        int heightPx) const
{
    StrokeLine line;
    for (const Eigen::Vector2d& point : points) {
        const bool isTouched = brushes() && (point - mouse_->imagePx).norm() <= brushPx();
        line.push_back({onCanvas(point, heightPx), isTouched ? curveTones().attention : tone});
    }
    return thinned(line, curveThinningPx);
}

StrokeMesh EditCurvesTool::strokes(int heightPx) const
{
    StrokeMesh mesh;
    addCurves(mesh, heightPx);
    addRegion(mesh, heightPx);
    addPath(mesh, heightPx);
    if (brushes()) {
        addBrush(mesh, heightPx);
    }
    return mesh;
}

void EditCurvesTool::addCurves(StrokeMesh& mesh, int heightPx) const
{
    const double ratio = view().devicePixelRatio();
    const double width = curveWidth * ratio;
    if (isDragging_) {
        for (const core::Curve2d& curve : curves_.curves) {   // what goes stays visible, faintly
            addLine(mesh, lineOnCanvas(curve.pointsPx, curveTones().hint, heightPx), {width, 0.6});
        }
    }
    for (const core::Curve2d& curve : shown_.curves) {
        const bool isSuspect = std::ranges::find(suspects_, curve.id) != suspects_.end();
        if (curve.id == hovered_ || curve.id == chosenSuspect_) {
            addShadowedLine(mesh, lineOnCanvas(curve.pointsPx, curveTones().textStrong, heightPx), 2.0 * width, 1.0);
        } else if (isSuspect) {
            addDashes(mesh, lineOnCanvas(curve.pointsPx, curveTones().attention, heightPx), width, 7.0 * ratio);
        } else {
            addShadowedLine(mesh, lineOnCanvas(curve.pointsPx, curveTones().accent, heightPx), width, 1.0);
        }
    }
    if (hovered_ >= 0 && edit_ == CurveEdit::Cut) {
        addDot(mesh, {onCanvas(nearestPoint(curves_, hovered_, mouse_->imagePx), heightPx), curveTones().attention},
               5.0 * ratio, 1.0);
    }
}

void EditCurvesTool::addRegion(StrokeMesh& mesh, int heightPx) const
{
    const double ratio = view().devicePixelRatio();
    if (std::vector<Eigen::Vector2d> ring = outline(); isDragging_ && ring.size() > 1) {
        ring.push_back(ring.front());
        const Color& tone = isKeeping_ ? curveTones().textStrong : curveTones().attention;
        addDashes(mesh, lineOnCanvas(ring, tone, heightPx), 1.4 * ratio, 5.0 * ratio);
    }
}

void EditCurvesTool::addPath(StrokeMesh& mesh, int heightPx) const
{
    const double ratio = view().devicePixelRatio();
    const double width = curveWidth * ratio;
    addShadowedLine(mesh, lineOnCanvas(path_.points(), curveTones().textStrong, heightPx), width, 1.0);
    addDashes(mesh, lineOnCanvas(path_.aimed(), curveTones().textStrong, heightPx), width, 5.0 * ratio);
    for (const Eigen::Vector2d& anchor : path_.anchors()) {
        addDot(mesh, {onCanvas(anchor, heightPx), curveTones().textStrong}, 4.0 * ratio, 1.0);
    }
}

void EditCurvesTool::addBrush(StrokeMesh& mesh, int heightPx) const
{
    StrokeLine circle;
    for (int k = 0; k <= 48; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 48;
        const Eigen::Vector2d onRim = mouse_->imagePx + brushPx() * Eigen::Vector2d(std::cos(angle), std::sin(angle));
        circle.push_back({onCanvas(onRim, heightPx), curveTones().textStrong});
    }
    addShadowedLine(mesh, circle, 1.4 * view().devicePixelRatio(), 0.9);
}

bool EditCurvesTool::brushes() const
{
    return edit_ == CurveEdit::Erase && mouse_ && isReady_;
}

double EditCurvesTool::brushPx() const
{
    return brushRadius_ / view().zoom();
}

}   // namespace angiopose::ui
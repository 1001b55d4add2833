// Drawing of EditCurvesTool: curves, brush, region and current path.
#include "core/tracing/angiogram/drawing/edit_centerline.h"
#include "ui/theme/active_theme.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tools/edit_curves_tool.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace angiopose::ui {
namespace {

constexpr double curveWidth = 2.2;   ///< px at 100 % scale

const Palette& curveTones()
{
    return palette(ThemeMode::Dark);
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

/// Returns the sections of a curve within `radiusPx` of a point, image px.
std::vector<std::vector<Eigen::Vector2d>> runsNear(const core::Curve2d& curve, const Eigen::Vector2d& place,
                                                   double radiusPx)
{
    std::vector<std::vector<Eigen::Vector2d>> runs;
    bool isOpen = false;
    for (const Eigen::Vector2d& point : curve.pointsPx) {
        const bool isNear = (point - place).norm() <= radiusPx;
        if (isNear && !isOpen) {
            runs.emplace_back();
        }
        if (isNear) {
            runs.back().push_back(point);
        }
        isOpen = isNear;
    }
    return runs;
}

}   // namespace

CurveCanvas EditCurvesTool::canvas(int heightPx) const
{
    const double ratio = view().devicePixelRatio();
    const QPointF origin = view().widgetFromImage({0.0, 0.0}) * ratio;
    const QPointF step = view().widgetFromImage({1.0, 1.0}) * ratio - origin;
    CurveCanvas canvas;
    canvas.canvasFromImage.linear() = Eigen::Vector2d(step.x(), -step.y()).asDiagonal();
    canvas.canvasFromImage.translation() = Eigen::Vector2d(origin.x(), heightPx - origin.y());
    canvas.widthPx = view().width() * ratio;
    canvas.heightPx = heightPx;
    canvas.pixelRatio = ratio;
    return canvas;
}

CurveStyle EditCurvesTool::idleStyle() const
{
    return {.widthPx = curveWidth, .suspectIds = marks_.suspects, .deviceIds = marks_.devices};
}

StrokeMesh EditCurvesTool::strokes(int heightPx) const
{
    const CurveCanvas canvas = this->canvas(heightPx);
    StrokeMesh mesh;
    if (isDragging_) {   // keeps removed parts faintly visible during a drag
        addCurves(mesh, canvas, curves_, {.widthPx = curveWidth, .isFaint = true});
        addCurves(mesh, canvas, shownCurves_, idleStyle());
    } else {
        mesh = idleStrokes_.of(shownRevision_, canvas, shownCurves_, idleStyle());
    }
    addTouched(mesh, canvas);
    addPicked(mesh, canvas);
    addRegion(mesh, canvas);
    addPath(mesh, canvas);
    addBrush(mesh, canvas);
    return mesh;
}

/// Adds the parts of curves under the brush, which a click would erase.
void EditCurvesTool::addTouched(StrokeMesh& mesh, const CurveCanvas& canvas) const
{
    if (!usesBrush()) {
        return;
    }
    for (const core::Curve2d& curve : shownCurves_.curves) {
        for (const std::vector<Eigen::Vector2d>& run : runsNear(curve, pointer_->imagePx, brushPx())) {
            addShadowed(mesh, canvas, lineOn(canvas, run, curveTones().attention), curveWidth * canvas.pixelRatio, 1.0);
        }
    }
}

void EditCurvesTool::addPicked(StrokeMesh& mesh, const CurveCanvas& canvas) const
{
    for (const core::Curve2d& curve : shownCurves_.curves) {
        if (curve.id == hovered_ || curve.id == chosenSuspect_) {
            addShadowed(mesh, canvas, lineOn(canvas, curve.pointsPx, curveTones().textStrong),
                        2.0 * curveWidth * canvas.pixelRatio, 1.0);
        }
    }
    if (hovered_ >= 0 && edit_ == CurveEdit::Cut) {
        const Eigen::Vector2d cutPx = nearestPoint(curves_, hovered_, pointer_->imagePx);
        addDot(mesh, {canvas.canvasFromImage * cutPx, curveTones().attention}, 5.0 * canvas.pixelRatio, 1.0);
    }
}

void EditCurvesTool::addRegion(StrokeMesh& mesh, const CurveCanvas& canvas) const
{
    if (std::vector<Eigen::Vector2d> ring = outline(); isDragging_ && ring.size() > 1) {
        ring.push_back(ring.front());
        const Color& tone = keepsInside_ ? curveTones().textStrong : curveTones().attention;
        addShadowedDashes(mesh, canvas, lineOn(canvas, ring, tone), 1.4 * canvas.pixelRatio, 5.0 * canvas.pixelRatio);
    }
}

void EditCurvesTool::addPath(StrokeMesh& mesh, const CurveCanvas& canvas) const
{
    const double width = curveWidth * canvas.pixelRatio;
    addShadowed(mesh, canvas, lineOn(canvas, path_.points(), curveTones().textStrong), width, 1.0);
    addShadowedDashes(mesh, canvas, lineOn(canvas, path_.preview(), curveTones().textStrong), width,
                      5.0 * canvas.pixelRatio);
    for (const Eigen::Vector2d& anchor : path_.anchors()) {
        addDot(mesh, {canvas.canvasFromImage * anchor, curveTones().textStrong}, 4.0 * canvas.pixelRatio, 1.0);
    }
}

void EditCurvesTool::addBrush(StrokeMesh& mesh, const CurveCanvas& canvas) const
{
    if (!usesBrush()) {
        return;
    }
    std::vector<Eigen::Vector2d> circle;
    for (int k = 0; k <= 48; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 48;
        circle.push_back(pointer_->imagePx + brushPx() * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    addShadowed(mesh, canvas, lineOn(canvas, circle, curveTones().textStrong), 1.4 * canvas.pixelRatio, 0.9);
}

bool EditCurvesTool::usesBrush() const
{
    return edit_ == CurveEdit::Erase && pointer_ && isReady_;
}

double EditCurvesTool::brushPx() const
{
    return brushRadius_ / view().zoom();
}

}   // namespace angiopose::ui

// What EditCurvesTool shows: curves, brush, region, path under way, and the signs of suspects.
#include "core/tracing/edit_centerline.h"
#include "ui/scenes/fill_strokes.h"
#include "ui/theme/active_theme.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tools/edit_curves_tool.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace ui {
namespace {

constexpr double signRadius = 10.0;
constexpr double signGap = 26.0;
constexpr double thinningStepPx = 0.7;
constexpr double curveWidth = 2.2;   ///< px at 100 %

const Palette& tones()
{
    return palette(ThemeMode::Dark);
}

void addShadowedLine(StrokeMesh& mesh, const StrokeLine& line, double widthPx, double opacity)
{
    StrokeLine shade = line;
    for (StrokePoint& point : shade) {
        point.color = tones().canvas;
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

/// A tick or a cross beside a suspect curve, in widget px.
struct EditCurvesTool::Sign {
    QPointF centre;
    int curveId = 0;
    bool accepts = false;
};

Eigen::Vector2d EditCurvesTool::onCanvas(const Eigen::Vector2d& imagePx, Canvas canvas) const
{
    const QPointF at = view().widgetFromImage(imagePx) * view().devicePixelRatio();
    return {at.x(), canvas.height - at.y()};
}

StrokeLine EditCurvesTool::lineOnCanvas(const std::vector<Eigen::Vector2d>& points, const Color& tone,
                                        Canvas canvas) const
{
    StrokeLine line;
    for (const Eigen::Vector2d& point : points) {
        const bool isTouched = brushes() && (point - mouse_->imagePx).norm() <= brushPx();
        line.push_back({onCanvas(point, canvas), isTouched ? tones().attention : tone});
    }
    return thinned(line, thinningStepPx);
}

void EditCurvesTool::drawStrokes(Canvas canvas) const
{
    StrokeMesh mesh;
    addCurves(mesh, canvas);
    addRegion(mesh, canvas);
    addPath(mesh, canvas);
    if (brushes()) {
        addBrush(mesh, canvas);
    }
    fillStrokes(mesh, canvas.height, canvas);
}

void EditCurvesTool::addCurves(StrokeMesh& mesh, Canvas canvas) const
{
    const double ratio = view().devicePixelRatio();
    const double width = curveWidth * ratio;
    if (isDragging_) {
        for (const core::Curve2d& curve : curves_.curves) {   // what goes stays visible, faintly
            addLine(mesh, lineOnCanvas(curve.pointsPx, tones().hint, canvas), {width, 0.6});
        }
    }
    for (const core::Curve2d& curve : shown_.curves) {
        const bool isSuspect = std::ranges::find(suspects_, curve.id) != suspects_.end();
        if (curve.id == hovered_) {
            addShadowedLine(mesh, lineOnCanvas(curve.pointsPx, tones().textStrong, canvas), 2.0 * width, 1.0);
        } else if (isSuspect) {
            addDashes(mesh, lineOnCanvas(curve.pointsPx, tones().attention, canvas), width, 7.0 * ratio);
        } else {
            addShadowedLine(mesh, lineOnCanvas(curve.pointsPx, tones().accent, canvas), width, 1.0);
        }
    }
    if (hovered_ >= 0 && edit_ == CurveEdit::Cut) {
        addDot(mesh, {onCanvas(nearestPoint(curves_, hovered_, mouse_->imagePx), canvas), tones().attention},
               5.0 * ratio, 1.0);
    }
}

void EditCurvesTool::addRegion(StrokeMesh& mesh, Canvas canvas) const
{
    const double ratio = view().devicePixelRatio();
    if (std::vector<Eigen::Vector2d> ring = outline(); isDragging_ && ring.size() > 1) {
        ring.push_back(ring.front());
        const Color& tone = isKeeping_ ? tones().textStrong : tones().attention;
        addDashes(mesh, lineOnCanvas(ring, tone, canvas), 1.4 * ratio, 5.0 * ratio);
    }
}

void EditCurvesTool::addPath(StrokeMesh& mesh, Canvas canvas) const
{
    const double ratio = view().devicePixelRatio();
    const double width = curveWidth * ratio;
    addShadowedLine(mesh, lineOnCanvas(path_.points(), tones().textStrong, canvas), width, 1.0);
    addDashes(mesh, lineOnCanvas(path_.aimed(), tones().textStrong, canvas), width, 5.0 * ratio);
    for (const Eigen::Vector2d& anchor : path_.anchors()) {
        addDot(mesh, {onCanvas(anchor, canvas), tones().textStrong}, 4.0 * ratio, 1.0);
    }
}

void EditCurvesTool::addBrush(StrokeMesh& mesh, Canvas canvas) const
{
    StrokeLine circle;
    for (int k = 0; k <= 48; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 48;
        const Eigen::Vector2d onRim = mouse_->imagePx + brushPx() * Eigen::Vector2d(std::cos(angle), std::sin(angle));
        circle.push_back({onCanvas(onRim, canvas), tones().textStrong});
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

std::vector<EditCurvesTool::Sign> EditCurvesTool::signs() const
{
    std::vector<Sign> all;
    if (!isReady_ || isDragging_) {
        return all;
    }
    for (const core::Curve2d& curve : curves_.curves) {
        if (std::ranges::find(suspects_, curve.id) != suspects_.end()) {
            const QPointF middle = view().widgetFromImage(curve.pointsPx[curve.pointsPx.size() / 2]);
            all.push_back({middle + QPointF(16.0, -0.5 * signGap), curve.id, true});
            all.push_back({middle + QPointF(16.0, 0.5 * signGap), curve.id, false});
        }
    }
    return all;
}

bool EditCurvesTool::clickSign(const ToolPoint& point)
{
    const std::vector<Sign> all = signs();
    const auto hit = std::ranges::find_if(all, [&](const Sign& sign) {
        const QPointF way = point.position - sign.centre;
        return std::hypot(way.x(), way.y()) <= signRadius + 2.0;
    });
    if (hit == all.end()) {
        return false;
    }
    if (hit->accepts) {
        emit suspectAccepted(hit->curveId);
    } else {
        report(core::withoutCurve(curves_, hit->curveId), tr("Mark as not a vessel"));
    }
    return true;
}

void EditCurvesTool::paint(QPainter& painter) const
{
    for (const Sign& sign : signs()) {
        const Color& tone = sign.accepts ? tones().fine : tones().attention;
        painter.setPen(QPen(toQColor(tone), 1.5));
        painter.setBrush(toQColor(tones().field, 0.85));
        painter.drawEllipse(sign.centre, signRadius, signRadius);
        painter.setPen(QPen(toQColor(tone), 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        const QPointF c = sign.centre;
        if (sign.accepts) {
            const std::array tick{c + QPointF(-4.5, 0.0), c + QPointF(-1.0, 3.5), c + QPointF(4.5, -3.5)};
            painter.drawPolyline(tick.data(), static_cast<int>(tick.size()));
        } else {
            painter.drawLine(c + QPointF(-3.5, -3.5), c + QPointF(3.5, 3.5));
            painter.drawLine(c + QPointF(-3.5, 3.5), c + QPointF(3.5, -3.5));
        }
    }
}

}   // namespace ui

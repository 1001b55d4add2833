#include "ui/views/tools/measure_tool.h"

#include "ui/views/angiogram_view.h"
#include "ui/views/mark_strokes.h"
#include "ui/views/paint_marks.h"

#include <QKeyEvent>
#include <QPainter>

#include <cmath>
#include <utility>

namespace angiopose::ui {
namespace {

using core::MeasurementKind;

constexpr double measureReachPx = 8.0;
constexpr std::size_t maxOutlinePoints = 1000;   // maximum of the case file format

double distancePx(const QPointF& a, const QPointF& b)
{
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

MarkShape shapeOf(MeasurementKind kind)
{
    return kind == MeasurementKind::Length  ? MarkShape::Length
           : kind == MeasurementKind::Angle ? MarkShape::Angle
                                            : MarkShape::Outline;
}

}   // namespace

MeasureTool::MeasureTool(MeasurementKind kind, AngiogramView& view) : ImageTool(view), kind_(kind) {}

void MeasureTool::showMeasurements(const std::vector<core::ImageMeasurement>& measurements)
{
    if (measurements == measurements_) {
        return;
    }
    measurements_ = measurements;
    dragged_.reset();
    if (view().tool() == this) {
        view().redraw();
    }
}

void MeasureTool::setLabelFunction(std::function<QString(const std::vector<Eigen::Vector2d>&)> label)
{
    labelFunction_ = std::move(label);
}

QString MeasureTool::caption() const
{
    switch (kind_) {
        case MeasurementKind::Length:
            return tr("Length: drag or click both ends · points can be moved");
        case MeasurementKind::Angle:
            return tr("Angle: click one end, the vertex, the other end · points can be moved");
        case MeasurementKind::Area:
            break;
    }
    return tr("Area: click along the outline; double-click or Enter closes it · points can be moved");
}

std::optional<MeasureTool::DraggedPoint> MeasureTool::draggableAt(const QPointF& position) const
{
    std::optional<DraggedPoint> nearest;
    double nearestPx = measureReachPx;
    for (std::size_t m = 0; m < measurements_.size(); ++m) {
        const std::vector<Eigen::Vector2d>& pixels = measurements_[m].pixels;
        for (std::size_t p = 0; p < pixels.size(); ++p) {
            const double distance = distancePx(view().widgetFromImage(pixels[p]), position);
            if (distance < nearestPx) {
                nearestPx = distance;
                nearest = DraggedPoint{m, p, pixels[p]};
            }
        }
    }
    return nearest;
}

bool MeasureTool::isAtFirst(const QPointF& position) const
{
    return !points_.empty() && distancePx(view().widgetFromImage(points_.front()), position) < measureReachPx;
}

bool MeasureTool::startDrag(const ToolPoint& pressed)
{
    dragged_ = points_.empty() ? draggableAt(pressed.position) : std::nullopt;
    isDrawing_ = !dragged_ && points_.empty() && kind_ == MeasurementKind::Length;
    if (isDrawing_) {
        points_ = {pressed.imagePx};
    }
    return true;   // accepts every drag, so that window/level does not change during measuring
}

void MeasureTool::drag(const ToolPoint& point)
{
    mousePx_ = point.imagePx;
    if (dragged_) {
        dragged_->pixel = point.imagePx;
    }
    view().redraw();
}

void MeasureTool::finishDrag(const ToolPoint& point)
{
    if (const auto dragged = std::exchange(dragged_, std::nullopt)) {
        emit pointMoved(static_cast<int>(dragged->measurement), static_cast<int>(dragged->point), point.imagePx);
    } else if (std::exchange(isDrawing_, false)) {
        points_.push_back(point.imagePx);
        finish();
    } else {
        click(point);   // a press with slight movement counts as a click
    }
}

void MeasureTool::cancelDrag()
{
    dragged_.reset();
    if (std::exchange(isDrawing_, false)) {
        points_.clear();
    }
    view().redraw();
}

bool MeasureTool::click(const ToolPoint& point)
{
    if (kind_ == MeasurementKind::Area && points_.size() > 2 && isAtFirst(point.position)) {
        finish();
        return true;
    }
    if (points_.empty() || points_.back() != point.imagePx) {
        points_.push_back(point.imagePx);
    }
    const std::size_t whole = kind_ == MeasurementKind::Length  ? 2
                              : kind_ == MeasurementKind::Angle ? 3
                                                                : maxOutlinePoints;
    if (points_.size() == whole) {
        finish();
    }
    return true;
}

bool MeasureTool::doubleClick(const ToolPoint&)
{
    if (kind_ == MeasurementKind::Area) {
        finish();
    }
    return true;
}

void MeasureTool::hover(const ToolPoint& point)
{
    mousePx_ = point.imagePx;
    if (!points_.empty()) {
        view().redraw();
    }
}

void MeasureTool::leave()
{
    mousePx_.reset();
    view().redraw();
}

bool MeasureTool::takesKey(const QKeyEvent& event) const
{
    const bool isPlain = (event.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    const int key = event.key();
    const bool isEnter = key == Qt::Key_Return || key == Qt::Key_Enter;
    return isPlain && (key == Qt::Key_Delete || (!points_.empty() && (isEnter || key == Qt::Key_Backspace)));
}

void MeasureTool::keyPress(const QKeyEvent& event)
{
    if (event.key() == Qt::Key_Delete) {
        emit removeRequested();
    } else if (event.key() == Qt::Key_Backspace) {
        points_.pop_back();
    } else if (kind_ == MeasurementKind::Area) {
        finish();
    }
    view().redraw();
}

bool MeasureTool::undoStep()
{
    const bool hadPoints = !points_.empty();
    drop();
    return hadPoints;
}

/// Completes the measurement; does nothing if it has too few points, so that further clicks add points.
void MeasureTool::finish()
{
    if (points_.size() < (kind_ == MeasurementKind::Length ? 2U : 3U)) {
        return;
    }
    const std::vector<Eigen::Vector2d> points = std::exchange(points_, {});
    emit drawn(points);
    view().redraw();
}

void MeasureTool::drop()
{
    dragged_.reset();
    isDrawing_ = false;
    points_.clear();
    view().redraw();
}

std::optional<QCursor> MeasureTool::cursor(bool isDragging) const
{
    return QCursor(isDragging && dragged_ ? Qt::ClosedHandCursor : Qt::CrossCursor);
}

std::vector<Eigen::Vector2d> MeasureTool::currentPoints() const
{
    std::vector<Eigen::Vector2d> points = dragged_ ? measurements_[dragged_->measurement].pixels : points_;
    if (dragged_) {
        points[dragged_->point] = dragged_->pixel;
    } else if (!points.empty() && mousePx_ && points.back() != *mousePx_) {
        points.push_back(*mousePx_);
    }
    return points;
}

std::vector<ImageMark> MeasureTool::marksInProgress() const
{
    const std::vector<Eigen::Vector2d> points = currentPoints();
    if (points.size() < 2) {
        return {};
    }
    const QString label = labelFunction_ && !dragged_ ? labelFunction_(points) : QString();
    const MarkShape whole = shapeOf(dragged_ ? measurements_[dragged_->measurement].kind : kind_);
    const bool isOpen = whole == MarkShape::Outline && points.size() < 3;
    return {{isOpen ? MarkShape::Length : whole, points, label.toStdString(), true}};
}

Eigen::Vector2d MeasureTool::positionOf(const Eigen::Vector2d& pixel) const
{
    const QPointF place = view().widgetFromImage(pixel);
    return {place.x(), place.y()};
}

StrokeMesh MeasureTool::strokes(int heightPx) const
{
    const double ratio = view().devicePixelRatio();
    const Palette& colors = palette(ThemeMode::Dark);
    return markStrokes(
        marksInProgress(), [this](const Eigen::Vector2d& pixel) { return positionOf(pixel); },
        {{ratio * view().width(), 1.0 * heightPx}, ratio}, colors, colors.canvas);
}

void MeasureTool::paint(QPainter& painter) const
{
    painter.save();
    for (const core::ImageMeasurement& measurement : measurements_) {
        for (const Eigen::Vector2d& pixel : measurement.pixels) {
            paintHandle(painter, positionOf(pixel), false);
        }
    }
    MarkBackground obstacles;
    obstacles.hasLines = true;
    paintMarks(
        painter, marksInProgress(), [this](const Eigen::Vector2d& pixel) { return positionOf(pixel); },
        std::move(obstacles));
    for (const Eigen::Vector2d& point : currentPoints()) {
        paintHandle(painter, positionOf(point), true);
    }
    painter.restore();
}

}   // namespace angiopose::ui

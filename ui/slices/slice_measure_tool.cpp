#include "ui/slices/slice_measure_tool.h"

#include "ui/slices/slice_measures.h"
#include "ui/slices/slice_view.h"
#include "ui/views/paint_marks.h"

#include <QKeyEvent>
#include <QPainter>

#include <cmath>
#include <utility>

namespace angiopose::ui {
namespace {

using core::MeasurementKind;
using core::SliceMeasurement;

constexpr double measureReachPx = 8.0;
constexpr std::size_t maxOutlinePoints = 1000;   // maximum of the case file format

double distancePx(const QPointF& a, const QPointF& b)
{
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

MarkShape shapeOf(const SliceMeasurement& measurement)
{
    const bool isOpen = measurement.kind == MeasurementKind::Area && measurement.pointsInPatient.size() < 3;
    return measurement.kind == MeasurementKind::Length || isOpen ? MarkShape::Length
           : measurement.kind == MeasurementKind::Angle          ? MarkShape::Angle
                                                                 : MarkShape::Outline;
}

}   // namespace

SliceMeasureTool::SliceMeasureTool(MeasurementKind kind, SliceModel& model) : SliceTool(model), kind_(kind)
{
    next_.kind = kind;
    connect(&model, &SliceModel::scanChanged, this, &SliceMeasureTool::drop);   // points of another scan are invalid
}

QString SliceMeasureTool::caption() const
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

std::optional<SliceMeasureTool::DraggedPoint> SliceMeasureTool::draggableAt(const SlicePointer& pointer) const
{
    const std::vector<LabeledMeasurement>& measurements = model().measurementData();
    std::optional<DraggedPoint> nearest;
    double nearestPx = measureReachPx;
    for (std::size_t m = 0; m < measurements.size(); ++m) {
        const SliceMeasurement& candidate = measurements[m].measurement;
        for (std::size_t p = 0; p < candidate.pointsInPatient.size(); ++p) {
            const double distance =
                distancePx(pointer.view.widgetFromPatient(candidate.pointsInPatient[p]), pointer.position);
            if (distance < nearestPx && isInSlice(candidate, pointer.view.plane(), pointer.view.grid())) {
                nearestPx = distance;
                nearest = DraggedPoint{m, p, candidate.pointsInPatient[p], candidate};
            }
        }
    }
    return nearest;
}

bool SliceMeasureTool::isInShownSlice(SliceView& view) const
{
    return isInSlice(next_, view.plane(), view.grid());
}

bool SliceMeasureTool::startDrag(const SlicePointer& pressed)
{
    const bool isFresh = next_.pointsInPatient.empty();
    dragged_ = isFresh ? draggableAt(pressed) : std::nullopt;
    isDrawing_ = !dragged_ && isFresh && kind_ == MeasurementKind::Length;
    if (isDrawing_) {
        addPoint(pressed);
    }
    return true;   // accepts every drag, so that measuring does not move the crosshair
}

void SliceMeasureTool::drag(const SlicePointer& pointer)
{
    pointer_ = pointer.pointInPatient;
    if (dragged_) {
        dragged_->at = pointer.pointInPatient;
    }
    requestRepaint();
}

void SliceMeasureTool::finishDrag(const SlicePointer& pointer)
{
    if (const auto dragged = std::exchange(dragged_, std::nullopt)) {
        const bool exists = stillExists(*dragged);
        const bool isInPlace = exists && isInSlice(model().measurementData()[dragged->measurement].measurement,
                                                   pointer.view.plane(), pointer.view.grid());
        if (!isInPlace) {   // undo removed the measurement, or it is no longer in the displayed slice
            drop();
            return;
        }
        emit pointMoved(static_cast<int>(dragged->measurement), static_cast<int>(dragged->point),
                        pointer.pointInPatient);
    } else if (std::exchange(isDrawing_, false)) {
        addPoint(pointer);
        finish();
    } else {
        click(pointer);   // a press with slight movement counts as a click
    }
}

/// Returns whether the measurement being dragged still exists unchanged.
bool SliceMeasureTool::stillExists(const DraggedPoint& dragged) const
{
    const auto& measurements = model().measurementData();
    return dragged.measurement < measurements.size() && measurements[dragged.measurement].measurement == dragged.whole;
}

void SliceMeasureTool::addPoint(const SlicePointer& pointer)
{
    std::vector<Eigen::Vector3d>& points = next_.pointsInPatient;
    if (!isInShownSlice(pointer.view)) {
        points.clear();
        next_.plane = pointer.view.plane();
    }
    if (points.empty() || points.back() != pointer.pointInPatient) {
        points.push_back(pointer.pointInPatient);
    }
}

bool SliceMeasureTool::click(const SlicePointer& pointer)
{
    std::vector<Eigen::Vector3d>& points = next_.pointsInPatient;
    const bool closes = kind_ == MeasurementKind::Area && points.size() > 2 && isInShownSlice(pointer.view) &&
                        distancePx(pointer.view.widgetFromPatient(points.front()), pointer.position) < measureReachPx;
    if (!closes) {
        addPoint(pointer);
    }
    const std::size_t whole = kind_ == MeasurementKind::Length  ? 2
                              : kind_ == MeasurementKind::Angle ? 3
                                                                : maxOutlinePoints;
    if (closes || points.size() == whole) {
        finish();
    }
    requestRepaint();
    return true;
}

bool SliceMeasureTool::doubleClick(const SlicePointer&)
{
    if (kind_ == MeasurementKind::Area) {
        finish();
    }
    return true;
}

void SliceMeasureTool::hover(const SlicePointer& pointer)
{
    pointer_ = isInShownSlice(pointer.view) ? std::optional(pointer.pointInPatient) : std::nullopt;
    if (!next_.pointsInPatient.empty()) {
        requestRepaint();
    }
}

void SliceMeasureTool::leave()
{
    pointer_.reset();
    requestRepaint();
}

bool SliceMeasureTool::takesKey(const QKeyEvent& event) const
{
    const bool isPlain = (event.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    const int key = event.key();
    const bool isEnter = key == Qt::Key_Return || key == Qt::Key_Enter;
    const bool isDrawn = !next_.pointsInPatient.empty();
    return isPlain && (key == Qt::Key_Delete || (isDrawn && (isEnter || key == Qt::Key_Backspace)));
}

void SliceMeasureTool::keyPress(const QKeyEvent& event)
{
    if (event.key() == Qt::Key_Delete) {
        emit removeRequested();
    } else if (event.key() == Qt::Key_Backspace) {
        next_.pointsInPatient.pop_back();
    } else if (kind_ == MeasurementKind::Area) {
        finish();
    }
    requestRepaint();
}

bool SliceMeasureTool::undoStep()
{
    const bool hadPoints = !next_.pointsInPatient.empty() || dragged_;
    drop();
    return hadPoints;
}

/// Completes the measurement; does nothing if it has too few points, so that further clicks add points.
void SliceMeasureTool::finish()
{
    if (next_.pointsInPatient.size() < (kind_ == MeasurementKind::Length ? 2U : 3U)) {
        return;
    }
    SliceMeasurement whole = next_;
    next_.pointsInPatient.clear();
    emit drawn(whole);
    requestRepaint();
}

void SliceMeasureTool::drop()
{
    dragged_.reset();
    isDrawing_ = false;
    next_.pointsInPatient.clear();
    pointer_.reset();
    requestRepaint();
}

SliceMeasurement SliceMeasureTool::currentMeasurement() const
{
    if (dragged_ && stillExists(*dragged_)) {
        SliceMeasurement moved = model().measurementData()[dragged_->measurement].measurement;
        moved.pointsInPatient.at(dragged_->point) = dragged_->at;
        return moved;
    }
    SliceMeasurement drawn = next_;
    if (!drawn.pointsInPatient.empty() && pointer_ && drawn.pointsInPatient.back() != *pointer_) {
        drawn.pointsInPatient.push_back(*pointer_);
    }
    return drawn;
}

void SliceMeasureTool::paint(QPainter& painter, SliceView& view) const
{
    const auto positionOf = [&view](const Eigen::Vector3d& point) -> Eigen::Vector2d {
        const QPointF at = view.widgetFromPatient(point);
        return {at.x(), at.y()};
    };
    painter.save();
    for (const LabeledMeasurement& measurementData : model().measurementData()) {
        if (isInSlice(measurementData.measurement, view.plane(), view.grid())) {
            for (const Eigen::Vector3d& point : measurementData.measurement.pointsInPatient) {
                paintHandle(painter, positionOf(point), false);
            }
        }
    }
    const SliceMeasurement current = currentMeasurement();
    if (!isInSlice(current, view.plane(), view.grid())) {
        painter.restore();
        return;
    }
    ImageMark mark{shapeOf(current), {}, {}, true};
    for (const Eigen::Vector3d& point : current.pointsInPatient) {
        mark.pixels.push_back(positionOf(point));
    }
    if (current.pointsInPatient.size() > 1) {
        mark.label = labelFunction_ ? labelFunction_(current).toStdString() : std::string();
        paintMarks(painter, {mark}, [](const Eigen::Vector2d& at) { return at; });
    }
    for (const Eigen::Vector2d& at : mark.pixels) {
        paintHandle(painter, at, true);
    }
    painter.restore();
}

}   // namespace angiopose::ui

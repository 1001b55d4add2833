#include "ui/slices/slice_annotations.h"
#include "ui/slices/slice_tool.h"
#include "ui/slices/slice_view.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

// Mouse and keyboard input of a slice view.

namespace angiopose::ui {
namespace {

constexpr double sliceZoomPerWheelStep = 1.15;
constexpr double slicePickTolerancePx = 8.0;
constexpr int fastSlices = 10;

Eigen::Vector2d toVector(const QPointF& point)
{
    return {point.x(), point.y()};
}

}   // namespace

void SliceView::stepBy(int slices)
{
    if (model_.hasScan()) {
        const core::SliceGrid& shown = grid();
        model_.setCrosshair(model_.crosshair() + slices * shown.thicknessMm * shown.normal);
    }
}

void SliceView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    viewport_.setWidgetSize(width(), height());
    isImageStale_ = true;
}

void SliceView::mousePressEvent(QMouseEvent* event)
{
    if (pressed_ != Qt::NoButton || !model_.hasScan()) {
        return;
    }
    pressed_ = event->button();
    pressedAt_ = lastAt_ = event->position();
    isDragging_ = false;
}

void SliceView::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF step = event->position() - lastAt_;
    const QPointF offset = event->position() - pressedAt_;
    if (pressed_ == Qt::NoButton) {
        hover(event->position());
        return;
    }
    const bool isStart = !isDragging_;
    isDragging_ = isDragging_ || 2.0 * offset.manhattanLength() >= QApplication::startDragDistance();
    if (!isDragging_) {
        return;
    }
    lastAt_ = event->position();
    pointer_ = event->position();
    if (dragTool(*event, isStart)) {
        update();
        return;
    }
    if (pressed_ == Qt::LeftButton) {
        model_.setCrosshair(patientFromWidget(event->position()));
    } else if (pressed_ == Qt::MiddleButton) {
        viewport_.panBy(toVector(step));
        isImageStale_ = true;
    } else if (pressed_ == Qt::RightButton) {
        changeWindow(step);
    }
    update();
}

/// Adjusts window/level by a drag: rightward widens the window, downward darkens, in proportion to the window width.
void SliceView::changeWindow(const QPointF& step)
{
    const GrayWindow& current = model_.window();
    const double perPx = std::max(1.0, current.width / 300.0);
    model_.setWindow({current.width + perPx * step.x(), current.level + perPx * step.y()});
}

void SliceView::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != pressed_) {
        return;
    }
    pressed_ = Qt::NoButton;
    SliceTool* tool = event->button() == Qt::LeftButton ? model_.tool() : nullptr;
    if (std::exchange(isToolDrag_, false) && tool) {
        tool->finishDrag(pointerAt(event->position(), event->modifiers()));
        return;
    }
    if (isDragging_ || !model_.hasScan() || (tool && tool->click(pointerAt(event->position(), event->modifiers())))) {
        return;
    }
    const Eigen::Vector3d point = patientFromWidget(event->position());
    if (event->button() == Qt::RightButton) {
        emit menuRequested(point, event->globalPosition().toPoint());
    } else if (event->button() == Qt::LeftButton) {
        if (const auto branch = branchAt(event->position())) {
            emit branchClicked(*branch, event->modifiers());
        }
        model_.setCrosshair(point);
        emit pointPicked(model_.crosshair());
    }
}

void SliceView::mouseDoubleClickEvent(QMouseEvent* event)
{
    SliceTool* tool = model_.hasScan() ? model_.tool() : nullptr;
    const bool isLeft = event->button() == Qt::LeftButton;
    if (isLeft && !(tool && tool->doubleClick(pointerAt(event->position(), event->modifiers())))) {
        emit enlargeRequested();
    }
}

void SliceView::wheelEvent(QWheelEvent* event)
{
    event->accept();
    const double steps = event->angleDelta().y() / 120.0;
    SliceTool* tool = model_.hasScan() ? model_.tool() : nullptr;
    if (tool && tool->wheel(pointerAt(event->position(), event->modifiers()), steps)) {
        return;
    }
    if (event->modifiers().testFlag(Qt::ControlModifier)) {
        viewport_.zoomAt(toVector(event->position()), std::pow(sliceZoomPerWheelStep, steps));
        isImageStale_ = true;
        update();
        return;
    }
    wheelSteps_ += steps;
    const int whole = static_cast<int>(wheelSteps_);
    wheelSteps_ -= whole;
    stepBy(whole);
}

void SliceView::keyPressEvent(QKeyEvent* event)
{
    if (filterToolKey(*event)) {
        return;
    }
    if (!model_.hasScan() ||
        !(event->modifiers().testFlag(Qt::ControlModifier) ? moveCrosshair(event->key()) : scrollSlices(*event))) {
        QWidget::keyPressEvent(event);
    }
}

bool SliceView::scrollSlices(const QKeyEvent& event)
{
    const int stride = event.modifiers().testFlag(Qt::ShiftModifier) ? fastSlices : 1;
    switch (event.key()) {
        case Qt::Key_PageUp:
        case Qt::Key_Up:
            stepBy(stride);
            return true;
        case Qt::Key_PageDown:
        case Qt::Key_Down:
            stepBy(-stride);
            return true;
        case Qt::Key_Home:
            stepBy(core::sliceCount(*model_.geometry(), plane_));
            return true;
        case Qt::Key_End:
            stepBy(-core::sliceCount(*model_.geometry(), plane_));
            return true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            emit pointPicked(model_.crosshair());
            return true;
        default:
            return false;
    }
}

bool SliceView::moveCrosshair(int key)
{
    const core::SliceGrid& shown = grid();
    const Eigen::Vector3d step = key == Qt::Key_Left    ? (-shown.columnStep).eval()
                                 : key == Qt::Key_Right ? shown.columnStep
                                 : key == Qt::Key_Up    ? (-shown.rowStep).eval()
                                 : key == Qt::Key_Down  ? shown.rowStep
                                                        : Eigen::Vector3d::Zero().eval();
    model_.setCrosshair(model_.crosshair() + step);
    return !step.isZero();
}

void SliceView::contextMenuEvent(QContextMenuEvent* event)
{
    if (event->reason() == QContextMenuEvent::Keyboard && model_.hasScan()) {
        const QPointF at = widgetFromPatient(model_.crosshair());
        emit menuRequested(model_.crosshair(), mapToGlobal(at.toPoint()));
    }
    event->accept();   // with the mouse, the menu opens when the right button is released without a drag
}

void SliceView::leaveEvent(QEvent*)
{
    hover(std::nullopt);
}

std::optional<int> SliceView::branchAt(const QPointF& position) const
{
    const core::VesselTree* tree = model_.tree();
    if (!tree) {
        return std::nullopt;
    }
    const double reach = visibleDistanceMm(content_.grid);
    const double pxPerMm = viewport_.zoom() / pixelSizeMm(content_.grid);
    std::optional<int> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const core::VesselBranch& branch : tree->branches) {
        if (model_.marks().hidden.contains(branch.id)) {
            continue;
        }
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            const double beforeMm = content_.grid.distanceMm(point);
            const QPointF offset = widgetFromPatient(point) - position;
            const double distancePx = std::hypot(offset.x(), offset.y());
            const double farPx = std::hypot(distancePx, beforeMm * pxPerMm);   // prefers points that lie in the slice
            if (std::abs(beforeMm) <= reach && distancePx < slicePickTolerancePx && farPx < least) {
                least = farPx;
                nearest = branch.id;
            }
        }
    }
    return nearest;
}

void SliceView::hover(const std::optional<QPointF>& position)
{
    pointer_ = model_.hasScan() ? position : std::nullopt;
    update();
    if (SliceTool* tool = model_.tool(); tool && pointer_) {
        tool->hover(pointerAt(*pointer_, QApplication::keyboardModifiers()));
    } else if (tool) {
        tool->leave();
    }
    const auto branch = pointer_ ? branchAt(*pointer_) : std::nullopt;
    if (branch != hovered_) {
        hovered_ = branch;
        emit branchHovered(branch);
    }
}

}   // namespace angiopose::ui

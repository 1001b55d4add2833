// The mouse and keyboard half of AngiogramView.
#include "ui/views/angiogram_interaction.h"
#include "ui/views/roll_cursor.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <climits>
#include <cmath>

namespace ui {
namespace {

constexpr double pickTolerancePx = 7.0;
constexpr double clickReachPx = 4.0;   // a press that moves less is a click
constexpr double finePace = 0.1;
constexpr double zoomPerWheelStep = 1.2;
constexpr double zoomPerDragPx = 1.008;
constexpr double windowPerDragPx = 1.0 / 300.0;   // of the window at hand

Eigen::Vector2d toVector(const QPointF& point)
{
    return {point.x(), point.y()};
}

}   // namespace

void AngiogramView::mousePressEvent(QMouseEvent* event)
{
    Interaction& i = *interaction_;
    if (i.pressed != Qt::NoButton) {
        if (event->button() == Qt::RightButton) {
            cancelDrag();
        }
        return;
    }
    i.pressed = event->button();
    i.isDragging = false;
    i.isCancelled = false;
    i.pressedAt = i.lastAt = event->position();
}

void AngiogramView::mouseMoveEvent(QMouseEvent* event)
{
    Interaction& i = *interaction_;
    if (cutout_ != Cutout::Shape::None) {
        placeCutout(event->position());
    }
    if (i.pressed == Qt::NoButton) {
        hoverAt(event->position());
        return;
    }
    if (i.isCancelled) {
        return;
    }
    const QPointF way = event->position() - i.pressedAt;
    if (!i.isDragging && std::hypot(way.x(), way.y()) >= clickReachPx) {
        i.isDragging = true;
        if (nudgeMode_ && i.pressed == Qt::LeftButton) {
            const NudgeGrip grip = i.grip(size());
            const PoseHandle handle = handleAt(grip, toVector(i.pressedAt));
            if (handle != PoseHandle::None) {
                i.nudge.emplace(handle, grip, toVector(i.pressedAt));
                emit dragStarted();
            }
        }
        showCursor();
    }
    if (i.isDragging) {
        dragBy(event->position(), event->modifiers());
    }
    i.lastAt = event->position();
}

void AngiogramView::dragBy(const QPointF& position, Qt::KeyboardModifiers modifiers)
{
    Interaction& i = *interaction_;
    const QPointF step = position - i.lastAt;
    if (i.pressed == Qt::MiddleButton) {
        i.viewport.panBy(toVector(step));
        update();
    } else if (i.pressed == Qt::RightButton) {
        zoomAt(i.pressedAt, std::pow(zoomPerDragPx, -step.y()));
    } else if (i.pressed == Qt::LeftButton && i.nudge) {
        nudgeBy(position, modifiers.testFlag(Qt::ControlModifier) ? finePace : 1.0);
    } else if (i.pressed == Qt::LeftButton && !nudgeMode_) {
        adjustWindowLevel(step);
    }
}

void AngiogramView::nudgeBy(const QPointF& position, double pace)
{
    const core::PoseOffset offset = interaction_->nudge->moveTo(toVector(position), pace);
    update();
    emit dragged(offset);
}

void AngiogramView::adjustWindowLevel(const QPointF& step)
{
    const core::DisplayRange range = interaction_->annotations.range;
    const double smallest = 1e-6 * std::max(1.0, std::abs(range.level()));
    const double window = std::max(smallest, range.window() * (1.0 + windowPerDragPx * step.x()));
    setWindowLevel(window, range.level() + range.window() * windowPerDragPx * step.y());
}

void AngiogramView::mouseReleaseEvent(QMouseEvent* event)
{
    Interaction& i = *interaction_;
    if (event->button() != i.pressed) {
        return;
    }
    const bool wasClick = !i.isDragging && !i.isCancelled && i.pressed == Qt::LeftButton;
    const bool wasNudge = i.nudge.has_value();
    i.pressed = Qt::NoButton;
    i.isDragging = false;
    i.nudge.reset();
    if (wasNudge) {
        emit dragFinished();
        update();
    }
    if (wasClick) {
        click(event->position(), event->modifiers());
    }
    hoverAt(event->position());
    showCursor();
}

void AngiogramView::cancelDrag()
{
    Interaction& i = *interaction_;
    if (i.pressed == Qt::NoButton || i.isCancelled) {
        return;
    }
    i.isCancelled = true;
    if (i.nudge) {
        i.nudge.reset();
        emit dragCancelled();
        update();
    }
    showCursor();
}

void AngiogramView::click(const QPointF& position, Qt::KeyboardModifiers modifiers)
{
    if (const auto branch = scene_.branchAt(imageFromWidget(position), pickTolerancePx / zoom())) {
        emit branchClicked(*branch, modifiers);
    } else {
        emit backgroundClicked();
    }
}

void AngiogramView::hoverAt(const QPointF& position)
{
    Interaction& i = *interaction_;
    if (nudgeMode_) {
        const NudgeGrip grip = i.grip(size());
        const PoseHandle handle = handleAt(grip, toVector(position));
        i.hotAngleRad = screenAngleRad(grip.centre, toVector(position));
        if (handle != i.hotHandle || handle == PoseHandle::Roll) {
            update();
        }
        i.hotHandle = handle;
    }
    hover(scene_.branchAt(imageFromWidget(position), pickTolerancePx / zoom()));
    showCursor();
}

void AngiogramView::hover(std::optional<int> branchId)
{
    if (branchId != interaction_->hovered) {
        interaction_->hovered = branchId;
        emit branchHovered(branchId);
    }
}

void AngiogramView::showCursor()
{
    const Interaction& i = *interaction_;
    const bool isDragging = i.isDragging && !i.isCancelled;
    if (nudgeMode_ && (!isDragging || i.pressed == Qt::LeftButton)) {
        const PoseHandle handle = i.nudge ? i.nudge->handle() : i.hotHandle;
        setCursor(handle == PoseHandle::Roll ? rollCursor() : QCursor(Qt::SizeAllCursor));
    } else if (isDragging) {
        setCursor(i.pressed == Qt::MiddleButton  ? Qt::ClosedHandCursor
                  : i.pressed == Qt::RightButton ? Qt::SizeVerCursor
                                                 : Qt::CrossCursor);
    } else {
        setCursor(i.hovered ? Qt::PointingHandCursor : Qt::ArrowCursor);
    }
}

void AngiogramView::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) {
        fitToWindow();
    }
}

void AngiogramView::zoomAt(const QPointF& position, double factor)
{
    interaction_->viewport.zoomAt(toVector(position), factor);
    update();
    emit zoomChanged(zoom());
}

void AngiogramView::wheelEvent(QWheelEvent* event)
{
    event->accept();
    const double steps = event->angleDelta().y() / 120.0;
    if (event->modifiers().testFlag(Qt::ControlModifier)) {
        zoomAt(event->position(), std::pow(zoomPerWheelStep, steps));
        return;
    }
    double& collected = interaction_->wheelSteps;
    collected += steps;
    const int whole = static_cast<int>(collected);
    collected -= whole;
    if (whole != 0) {
        emit frameStepRequested(-whole);
    }
}

void AngiogramView::keyPressEvent(QKeyEvent* event)
{
    const bool isDragging = interaction_->pressed != Qt::NoButton && !interaction_->isCancelled;
    if (event->key() == Qt::Key_Escape && isDragging) {
        cancelDrag();
        return;
    }
    if (!nudgeMode_) {
        const int stride = event->modifiers().testFlag(Qt::ShiftModifier) ? 10 : 1;
        switch (event->key()) {
            case Qt::Key_Up:
                emit frameStepRequested(-stride);
                return;
            case Qt::Key_Down:
                emit frameStepRequested(stride);
                return;
            case Qt::Key_Home:
                emit frameStepRequested(INT_MIN);
                return;
            case Qt::Key_End:
                emit frameStepRequested(INT_MAX);
                return;
            default:
                break;
        }
    }
    QWidget::keyPressEvent(event);
}

bool AngiogramView::event(QEvent* event)
{
    // While the tree is being dragged, Esc belongs to the drag, whatever shortcut the window has for it.
    const bool isDragging = interaction_ && interaction_->pressed != Qt::NoButton && !interaction_->isCancelled;
    if (event->type() == QEvent::ShortcutOverride && isDragging &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void AngiogramView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    interaction_->viewport.setWidgetSize(width(), height());
    emit zoomChanged(zoom());
}

void AngiogramView::leaveEvent(QEvent*)
{
    if (interaction_->pressed == Qt::NoButton) {
        hover(std::nullopt);
        interaction_->hotHandle = PoseHandle::None;
        update();
    }
}

void AngiogramView::hideEvent(QHideEvent* event)
{
    cancelDrag();
    QWidget::hideEvent(event);
}

}   // namespace ui

// Mouse and keyboard input of AngiogramView; drags are in angiogram_view_drag.cpp, input of tools in
// angiogram_view_tools.cpp.
#include "ui/views/angiogram_interaction.h"

#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <climits>
#include <cmath>
#include <utility>

namespace angiopose::ui {
namespace {

constexpr double framePickTolerancePx = 7.0;
constexpr double clickReachPx = 4.0;   // widget px; smaller movements count as clicks
constexpr double frameZoomPerWheelStep = 1.2;

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
    i.pressedWith = event->modifiers();
}

void AngiogramView::mouseMoveEvent(QMouseEvent* event)
{
    Interaction& i = *interaction_;
    if (cutout_ != Cutout::Shape::None) {
        placeCutout(event->position());
    }
    emit pointerMoved(imageFromWidget(event->position()));
    if (i.pressed == Qt::NoButton) {
        hoverAt(event->position());
        return;
    }
    if (i.isCancelled) {
        return;
    }
    const QPointF offset = event->position() - i.pressedAt;
    if (!i.isDragging && std::hypot(offset.x(), offset.y()) >= clickReachPx) {
        startDrag();
    }
    if (i.isDragging) {
        dragBy(event->position(), event->modifiers());
    }
    i.lastAt = event->position();
}

/// Requests a change by whole frames and keeps the remaining fraction.
void AngiogramView::scrollFrames(double frames)
{
    double& collected = interaction_->wheelSteps;
    collected += frames;
    const int whole = static_cast<int>(collected);
    collected -= whole;
    if (whole != 0) {
        emit frameStepRequested(whole);
    }
}

void AngiogramView::setMousePreset(const MousePreset& preset)
{
    interaction_->mouse = preset;
}

void AngiogramView::mouseReleaseEvent(QMouseEvent* event)
{
    Interaction& i = *interaction_;
    if (event->button() != i.pressed) {
        return;
    }
    const bool wasStill = !i.isDragging && !i.isCancelled;
    i.pressed = Qt::NoButton;
    i.isDragging = false;
    if (std::exchange(i.isToolDragging, false) && i.tool) {
        i.tool->finishDrag(i.toolPoint(event->position(), event->modifiers()));
        redraw();
    }
    if (wasStill && event->button() == Qt::LeftButton) {
        click(event->position(), event->modifiers());
    } else if (wasStill && event->button() == Qt::RightButton) {
        emit menuRequested(event->globalPosition().toPoint(), branchAt(event->position()));
    }
    hoverAt(event->position());
    showCursor();
}

void AngiogramView::click(const QPointF& position, Qt::KeyboardModifiers modifiers)
{
    Interaction& i = *interaction_;
    if (i.tool && i.tool->click(i.toolPoint(position, modifiers))) {
        redraw();
        return;
    }
    if (i.tool && !i.tool->picksBranches()) {
        return;
    }
    if (const auto branch = branchAt(position)) {
        emit branchClicked(*branch, modifiers);
    } else {
        emit backgroundClicked();
    }
}

void AngiogramView::hoverAt(const QPointF& position)
{
    Interaction& i = *interaction_;
    if (i.tool) {
        i.tool->hover(i.toolPoint(position, QGuiApplication::keyboardModifiers()));
    }
    hover(i.tool && !i.tool->picksBranches() ? std::nullopt : branchAt(position));
    showCursor();
}

std::optional<int> AngiogramView::branchAt(const QPointF& position) const
{
    return scene_.branchAt(imageFromWidget(position), framePickTolerancePx / zoom());
}

/// Handles the menu key; with the mouse, the menu opens when the right button is released without a drag.
void AngiogramView::contextMenuEvent(QContextMenuEvent* event)
{
    event->accept();
    if (event->reason() == QContextMenuEvent::Keyboard) {
        emit menuRequested(mapToGlobal(rect().center()), interaction_->hovered);
    }
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
    if (i.tool && (!isDragging || i.isToolDragging)) {
        if (const auto cursor = i.tool->cursor(isDragging)) {
            setCursor(*cursor);
            return;
        }
    }
    if (isDragging) {
        setCursor(i.dragAction == DragAction::Pan           ? Qt::ClosedHandCursor
                  : i.dragAction == DragAction::WindowLevel ? Qt::CrossCursor
                  : i.dragAction == DragAction::None        ? Qt::ArrowCursor
                                                            : Qt::SizeVerCursor);
    } else {
        setCursor(i.hovered ? Qt::PointingHandCursor : Qt::ArrowCursor);
    }
}

void AngiogramView::mouseDoubleClickEvent(QMouseEvent* event)
{
    Interaction& i = *interaction_;
    if (event->button() != Qt::LeftButton) {
        return;
    }
    if (i.tool && i.tool->doubleClick(i.toolPoint(event->position(), event->modifiers()))) {
        redraw();
        return;
    }
    emit enlargeRequested();
}

void AngiogramView::zoomAt(const QPointF& position, double factor)
{
    interaction_->viewport.zoomAt({position.x(), position.y()}, factor);
    redraw();
    emit zoomChanged(zoom());
}

void AngiogramView::wheelEvent(QWheelEvent* event)
{
    event->accept();
    const double steps = event->angleDelta().y() / 120.0;
    if (event->modifiers().testFlag(Qt::ControlModifier)) {
        zoomAt(event->position(), std::pow(frameZoomPerWheelStep, steps));
        return;
    }
    scrollFrames(-steps);
}

void AngiogramView::keyPressEvent(QKeyEvent* event)
{
    if (filterToolKey(*event)) {
        return;
    }
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
            QWidget::keyPressEvent(event);
    }
}

void AngiogramView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    interaction_->viewport.setWidgetSize(width(), height());
    emit zoomChanged(zoom());
}

void AngiogramView::leaveEvent(QEvent*)
{
    emit pointerMoved(std::nullopt);
    if (interaction_->pressed == Qt::NoButton) {
        hover(std::nullopt);
        if (interaction_->tool) {
            interaction_->tool->leave();
        }
        redraw();
    }
}

void AngiogramView::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    redraw();
}

void AngiogramView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    redraw();
}

void AngiogramView::hideEvent(QHideEvent* event)
{
    cancelDrag();
    QWidget::hideEvent(event);
}

}   // namespace angiopose::ui

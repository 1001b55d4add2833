// Drags in AngiogramView: pan, zoom, window/level, frames, or the action of the tool.
#include "ui/views/angiogram_interaction.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace angiopose::ui {
namespace {

constexpr double zoomPerDragPx = 1.008;
constexpr double windowPerDragPx = 1.0 / 300.0;   // change per px, as a fraction of the current window
constexpr double framesPerDragPx = 1.0 / 12.0;

}   // namespace

void AngiogramView::startDrag()
{
    Interaction& i = *interaction_;
    i.isDragging = true;
    i.isToolDragging =
        i.tool && i.pressed == Qt::LeftButton && i.tool->startDrag(i.toolPoint(i.pressedAt, i.pressedWith));
    i.dragAction = i.mouse.actionOf(i.pressed, i.pressedWith);
    showCursor();
}

void AngiogramView::dragBy(const QPointF& position, Qt::KeyboardModifiers modifiers)
{
    Interaction& i = *interaction_;
    const QPointF step = position - i.lastAt;
    if (i.isToolDragging && i.tool) {
        i.tool->drag(i.toolPoint(position, modifiers));
        return;
    }
    switch (i.dragAction) {
        case DragAction::Pan:
            i.viewport.panBy({step.x(), step.y()});
            redraw();
            break;
        case DragAction::Zoom:
            zoomAt(i.pressedAt, std::pow(zoomPerDragPx, -step.y()));
            break;
        case DragAction::WindowLevel:
            adjustWindowLevel(step);
            break;
        case DragAction::Frames:
            scrollFrames(framesPerDragPx * step.y());
            break;
        case DragAction::None:
            break;
    }
}

void AngiogramView::adjustWindowLevel(const QPointF& step)
{
    const core::DisplayRange range = interaction_->annotations.range;
    const double smallest = 1e-6 * std::max(1.0, std::abs(range.level()));
    const double window = std::max(smallest, range.window() * (1.0 + windowPerDragPx * step.x()));
    setWindowLevel(window, range.level() + range.window() * windowPerDragPx * step.y());
}

bool AngiogramView::cancelDrag()
{
    Interaction& i = *interaction_;
    if (i.pressed == Qt::NoButton || i.isCancelled) {
        return false;
    }
    i.isCancelled = true;
    if (std::exchange(i.isToolDragging, false) && i.tool) {
        i.tool->cancelDrag();
        redraw();
    }
    showCursor();
    return true;
}

}   // namespace angiopose::ui

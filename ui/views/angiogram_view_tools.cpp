// Tool support of AngiogramView: left button, keys, Esc, and bars at the bottom.
#include "ui/views/angiogram_interaction.h"

#include <QKeyEvent>
#include <QVBoxLayout>

#include <utility>

namespace angiopose::ui {

void AngiogramView::setTool(ImageTool* tool)
{
    Interaction& i = *interaction_;
    if (tool == i.tool) {
        return;
    }
    cancelDrag();
    if (ImageTool* former = std::exchange(i.tool, nullptr)) {
        former->end();
    }
    i.tool = tool;
    scene_.setOverlayHidden(tool && tool->hidesOverlay());
    hover(std::nullopt);
    if (tool) {
        tool->begin();
    }
    showCursor();
    redraw();
    emit toolChanged();
}

ImageTool* AngiogramView::tool() const
{
    return interaction_->tool;
}

void AngiogramView::addBar(QWidget* bar)
{
    auto* bars = qobject_cast<QVBoxLayout*>(layout());
    if (!bars) {
        bars = new QVBoxLayout(this);
        bars->setSizeConstraint(QLayout::SetNoConstraint);
        bars->setContentsMargins(0, 0, 0, 14);
        bars->addStretch(1);
    }
    bar->setAttribute(Qt::WA_NoMousePropagation);
    bars->addWidget(bar, 0, Qt::AlignHCenter);
}

/// Handles Esc: cancels the drag or, without one, the current action of the tool, or else ends the tool.
bool AngiogramView::escape()
{
    if (cancelDrag()) {
        return true;
    }
    ImageTool* tool = interaction_->tool;
    if (tool && !tool->undoStep()) {
        setTool(nullptr);
    }
    redraw();
    return tool != nullptr;
}

bool AngiogramView::filterToolKey(QKeyEvent& event)
{
    const Interaction& i = *interaction_;
    const bool isDragging = i.pressed != Qt::NoButton && !i.isCancelled;
    const bool isEscape = event.key() == Qt::Key_Escape && (isDragging || i.tool);
    const bool isTools = i.tool && i.tool->takesKey(event);
    if (event.type() == QEvent::ShortcutOverride) {
        if (isEscape || isTools) {
            event.accept();   // makes Qt deliver the key as KeyPress instead of triggering a shortcut
        }
        return isEscape || isTools;
    }
    if (event.type() != QEvent::KeyPress || !(isEscape || isTools)) {
        return false;
    }
    if (isTools) {
        i.tool->keyPress(event);
        return true;
    }
    return escape();
}

bool AngiogramView::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && interaction_ && filterToolKey(*static_cast<QKeyEvent*>(event))) {
        return true;
    }
    return QWidget::event(event);
}

}   // namespace angiopose::ui

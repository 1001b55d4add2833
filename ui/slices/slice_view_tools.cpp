#include "ui/slices/slice_tool.h"
#include "ui/slices/slice_view.h"

#include <QKeyEvent>

// Mouse and keyboard input that a slice view passes to its tool.

namespace angiopose::ui {

SlicePointer SliceView::pointerAt(const QPointF& position, Qt::KeyboardModifiers modifiers)
{
    resample();
    return {*this, position, patientFromWidget(position), modifiers};
}

/// Returns whether the tool handles the drag.
bool SliceView::dragTool(const QMouseEvent& event, bool isStart)
{
    SliceTool* tool = model_.tool();
    if (!tool || pressed_ != Qt::LeftButton) {
        return false;
    }
    if (isStart) {
        isToolDrag_ = tool->startDrag(pointerAt(pressedAt_, event.modifiers()));
    }
    if (isToolDrag_) {
        tool->drag(pointerAt(event.position(), event.modifiers()));
    }
    return isToolDrag_;
}

/// Returns whether a tool is active and accepts the key.
bool SliceView::wantsToolKey(const QKeyEvent& event) const
{
    const SliceTool* tool = model_.tool();
    return tool && model_.hasScan() && tool->takesKey(event);
}

bool SliceView::filterToolKey(QKeyEvent& event)
{
    SliceTool* tool = model_.tool();
    if (!tool || !model_.hasScan()) {
        return false;
    }
    const bool isEscape = event.key() == Qt::Key_Escape;
    const bool isToolKey = tool->takesKey(event);
    if (!isEscape && !isToolKey) {
        return false;
    }
    if (event.type() == QEvent::ShortcutOverride) {
        event.accept();   // makes Qt deliver the key as KeyPress instead of triggering a shortcut
    } else if (isToolKey) {
        tool->keyPress(event);
    } else {
        isToolDrag_ = false;
        pressed_ = Qt::NoButton;   // ignores the remaining events of the drag
        if (!tool->undoStep()) {
            model_.setTool(nullptr);
        }
    }
    return true;
}

bool SliceView::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && filterToolKey(*static_cast<QKeyEvent*>(event))) {
        return true;
    }
    return QWidget::event(event);
}

void SliceView::followTool()
{
    isToolDrag_ = false;
    if (const SliceTool* tool = model_.tool()) {
        setCursor(tool->cursor());
    } else {
        unsetCursor();
    }
    update();
}

}   // namespace angiopose::ui

#pragma once

#include "ui/scenes/stroke_mesh.h"
#include "ui/theme/theme.h"

#include <Eigen/Core>
#include <QCursor>
#include <QObject>
#include <QPointF>

#include <optional>

class QKeyEvent;
class QPainter;

namespace angiopose::ui {

class AngiogramView;

/// Pointer position on the angiogram.
struct ToolPoint {
    QPointF position;   ///< widget px
    Eigen::Vector2d imagePx = Eigen::Vector2d::Zero();
    Qt::KeyboardModifiers modifiers;
};

/// Tool that handles the left button and the keys on the angiogram while its mode is on. One class per mode, one tool
/// at a time (`AngiogramView::setTool`, `bindTool`). Pan, zoom and the wheel are unaffected. Events that a tool does
/// not accept go to the view: drags adjust window/level, clicks pick branches. Esc cancels the action or ends the mode.
class ImageTool : public QObject {
    Q_OBJECT
public:
    explicit ImageTool(AngiogramView& view);   ///< the tool becomes a child of the view

    virtual QString caption() const = 0;   ///< describes the current mouse action in one line at the top of the image
    virtual const Color& tone() const;   ///< color of border and caption, by default the accent color
    virtual void begin() {}
    virtual void end() {}   ///< discards the current action

    /// Called when the left button moves farther than in a click, from `pressed` on; false leaves the drag to the view.
    virtual bool startDrag(const ToolPoint&) { return false; }
    virtual void drag(const ToolPoint&) {}
    virtual void finishDrag(const ToolPoint&) {}
    virtual void cancelDrag() {}   ///< restores the state before the drag
    virtual bool click(const ToolPoint&) { return false; }
    virtual bool doubleClick(const ToolPoint&) { return false; }   ///< called after the click of the first press
    virtual void hover(const ToolPoint&) {}
    virtual void leave() {}   ///< called when the pointer has left the image

    virtual bool takesKey(const QKeyEvent&) const { return false; }   ///< true if it precedes window shortcuts
    virtual void keyPress(const QKeyEvent&) {}   ///< called only for keys accepted by `takesKey`
    virtual bool undoStep() { return false; }   ///< called on Esc; returns true if this canceled an action

    virtual bool picksBranches() const { return true; }   ///< if false, the mouse does not pick branches
    virtual bool hidesOverlay() const { return false; }   ///< if true, hides the tree and the traced curves
    virtual std::optional<QCursor> cursor(bool /*isDragging*/) const { return std::nullopt; }
    virtual StrokeMesh strokes(int /*heightPx*/) const
    {
        return {};
    }   ///< strokes above the tree, device px; `heightPx` is the image height
    virtual void paint(QPainter&) const {}   ///< draws in widget px, on top of everything else

protected:
    AngiogramView& view() const { return view_; }

private:
    AngiogramView& view_;
};

}   // namespace angiopose::ui

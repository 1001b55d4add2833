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

/// Where the mouse is.
struct ToolPoint {
    QPointF position;   ///< widget px
    Eigen::Vector2d imagePx = Eigen::Vector2d::Zero();
    Qt::KeyboardModifiers modifiers;
};

/// What the left button and the keys do on the angiogram while a mode is on. One class per mode, one tool at a time
/// (`AngiogramView::setTool`, `bindTool`). Pan, zoom and the wheel stay as they are; what a tool does not take falls to
/// the view: drags set window and level, clicks pick branches. Esc takes back what is under way, then ends the mode.
class ImageTool : public QObject {
    Q_OBJECT
public:
    explicit ImageTool(AngiogramView& view);   ///< which also owns it

    virtual QString caption() const = 0;   ///< what the mouse does now: one line at the top of the image
    virtual const Color& tone() const;   ///< of border and caption; the accent unless told
    virtual void begin() {}
    virtual void end() {}   ///< drops what is under way

    /// The left button moved beyond a click, from `pressed` on; false leaves the drag to the view.
    virtual bool startDrag(const ToolPoint&) { return false; }
    virtual void drag(const ToolPoint&) {}
    virtual void finishDrag(const ToolPoint&) {}
    virtual void cancelDrag() {}   ///< nothing of it may stay
    virtual bool click(const ToolPoint&) { return false; }
    virtual bool doubleClick(const ToolPoint&) { return false; }   ///< after its first click
    virtual void hover(const ToolPoint&) {}
    virtual void leave() {}   ///< the mouse left the image

    virtual bool takesKey(const QKeyEvent&) const { return false; }   ///< before any shortcut of the window
    virtual void keyPress(const QKeyEvent&) {}   ///< of a key it takes
    virtual bool takeBack() { return false; }   ///< Esc: true when something was under way

    virtual bool picksBranches() const { return true; }   ///< false: the tree does not answer the mouse
    virtual bool hidesOverlay() const { return false; }   ///< tree and traced curves would be in the way
    virtual std::optional<QCursor> cursor(bool /*isDragging*/) const { return std::nullopt; }
    virtual StrokeMesh strokes(int /*heightPx*/) const
    {
        return {};
    }   ///< above the tree; of a picture so high, device px
    virtual void paint(QPainter&) const {}   ///< widget px, above everything

protected:
    AngiogramView& view() const { return view_; }

private:
    AngiogramView& view_;
};

}   // namespace angiopose::ui
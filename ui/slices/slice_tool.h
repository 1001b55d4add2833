#pragma once

#include <Eigen/Core>
#include <QCursor>
#include <QObject>
#include <QPointF>
#include <QString>

#include <optional>

class QAction;
class QKeyEvent;
class QPainter;

namespace angiopose::ui {

class SliceModel;
class SliceView;

/// Pointer position in a slice.
struct SlicePointer {
    SliceView& view;
    QPointF position;   ///< widget px
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();   ///< point in the slice plane
    Qt::KeyboardModifiers modifiers;
};

/// Tool that handles the left button, the wheel and the keys in all slices while its mode is on. Only one tool is
/// active (`SliceModel::setTool`). The view handles events that the tool does not accept: drags and clicks set the
/// crosshair, the wheel scrolls the slices. Esc cancels the current action, or else ends the mode.
class SliceTool : public QObject {
    Q_OBJECT
public:
    explicit SliceTool(SliceModel& model);   ///< the tool becomes a child of the model

    virtual QString caption() const = 0;   ///< describes the current mouse action
    virtual void end() {}   ///< discards the current action

    /// Called when the left button moves farther than in a click, from `pressed` on; false leaves the drag to the view.
    virtual bool startDrag(const SlicePointer&) { return false; }
    virtual void drag(const SlicePointer&) {}
    virtual void finishDrag(const SlicePointer&) {}
    virtual bool click(const SlicePointer&) { return false; }
    virtual bool doubleClick(const SlicePointer&) { return false; }   ///< called after the click of the first press
    virtual void hover(const SlicePointer&) {}
    virtual void leave() {}
    virtual bool wheel(const SlicePointer&, double /*steps*/) { return false; }

    virtual bool takesKey(const QKeyEvent&) const { return false; }   ///< true if it precedes window shortcuts
    virtual void keyPress(const QKeyEvent&) {}   ///< called only for keys accepted by `takesKey`
    virtual bool undoStep() { return false; }   ///< called on Esc; returns true if this canceled an action

    virtual QCursor cursor() const { return Qt::CrossCursor; }
    virtual void paint(QPainter&, SliceView&) const {}   ///< draws in widget px, on top of everything else

protected:
    SliceModel& model() const { return model_; }
    void requestRepaint();   ///< repaints all slices

private:
    SliceModel& model_;
};

/// Binds a checkable action to a tool; the action is unchecked when another tool takes over or Esc ends the mode.
void bindSliceTool(QAction& action, SliceModel& model, SliceTool& tool);

}   // namespace angiopose::ui

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

/// Mouse position in a slice.
struct SlicePointer {
    SliceView& view;
    QPointF position;   ///< widget px
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();   ///< in the plane of the slice
    Qt::KeyboardModifiers modifiers;
};

/// Handler of the left button, the wheel and the keys in all slices while a mode is on: one tool at a time
/// (`SliceModel::setTool`). Events that a tool does not accept go to the view: drags and clicks set the cross-hair, the
/// wheel scrolls the slices. Esc cancels the current action, then ends the mode.
class SliceTool : public QObject {
    Q_OBJECT
public:
    explicit SliceTool(SliceModel& model);   ///< the model also owns the tool

    virtual QString caption() const = 0;   ///< current mouse action
    virtual void end() {}   ///< discards the current action

    /// Starts when the left button moves beyond a click, from `pressed` on; false leaves the drag to the view.
    virtual bool startDrag(const SlicePointer&) { return false; }
    virtual void drag(const SlicePointer&) {}
    virtual void finishDrag(const SlicePointer&) {}
    virtual bool click(const SlicePointer&) { return false; }
    virtual bool doubleClick(const SlicePointer&) { return false; }   ///< follows its first click
    virtual void hover(const SlicePointer&) {}
    virtual void leave() {}
    virtual bool wheel(const SlicePointer&, double /*steps*/) { return false; }

    virtual bool takesKey(const QKeyEvent&) const { return false; }   ///< takes precedence over window shortcuts
    virtual void keyPress(const QKeyEvent&) {}   ///< only keys accepted by takesKey
    virtual bool takeBack() { return false; }   ///< Esc: true if an action was canceled

    virtual QCursor cursor() const { return Qt::CrossCursor; }
    virtual void paint(QPainter&, SliceView&) const {}   ///< widget px, on top of everything

protected:
    SliceModel& model() const { return model_; }
    void lookAgain();   ///< repaints all slices

private:
    SliceModel& model_;
};

/// Binds a checkable action to a tool; the action is unchecked when another tool takes over or Esc ends the mode.
void bindSliceTool(QAction& action, SliceModel& model, SliceTool& tool);

}   // namespace angiopose::ui

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

/// Where the mouse is in a slice.
struct SlicePointer {
    SliceView& view;
    QPointF position;   ///< widget px
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();   ///< in the plane of the slice
    Qt::KeyboardModifiers modifiers;
};

/// What the left button, the wheel and the keys do in all slices while a mode is on: one tool at a time
/// (`SliceModel::setTool`). What a tool does not take falls to the view: drags and clicks set the cross-hair, the wheel
/// goes through the slices. Esc takes back what is under way, then ends the mode.
class SliceTool : public QObject {
    Q_OBJECT
public:
    explicit SliceTool(SliceModel& model);   ///< which also owns it

    virtual QString caption() const = 0;   ///< what the mouse does now
    virtual void end() {}   ///< drops what is under way

    /// The left button moved beyond a click, from `pressed` on; false leaves the drag to the view.
    virtual bool startDrag(const SlicePointer&) { return false; }
    virtual void drag(const SlicePointer&) {}
    virtual void finishDrag(const SlicePointer&) {}
    virtual bool click(const SlicePointer&) { return false; }
    virtual bool doubleClick(const SlicePointer&) { return false; }   ///< after its first click
    virtual void hover(const SlicePointer&) {}
    virtual void leave() {}
    virtual bool wheel(const SlicePointer&, double /*steps*/) { return false; }

    virtual bool takesKey(const QKeyEvent&) const { return false; }   ///< before any shortcut of the window
    virtual void keyPress(const QKeyEvent&) {}   ///< of a key it takes
    virtual bool takeBack() { return false; }   ///< Esc: true when something was under way

    virtual QCursor cursor() const { return Qt::CrossCursor; }
    virtual void paint(QPainter&, SliceView&) const {}   ///< widget px, above everything

protected:
    SliceModel& model() const { return model_; }
    void lookAgain();   ///< all slices paint once more

private:
    SliceModel& model_;
};

/// Lets a checkable action switch a tool on and off; it follows when another takes over, or when Esc ends it.
void bindSliceTool(QAction& action, SliceModel& model, SliceTool& tool);

}   // namespace angiopose::ui

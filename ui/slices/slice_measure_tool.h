#pragma once

#include "core/imaging/slice_measurement.h"
#include "ui/slices/slice_tool.h"

#include <functional>
#include <vector>

namespace angiopose::ui {

/// Measuring tool for slices, operated like MeasureTool: clicks set points, and a drag draws a whole length or moves an
/// existing point; a click on the first point, a double-click or Enter closes an area. All points lie in one slice: a
/// click in another slice starts over.
class SliceMeasureTool : public SliceTool {
    Q_OBJECT
public:
    SliceMeasureTool(core::MeasurementKind kind, SliceModel& model);

    /// Sets the function that labels a measurement being drawn.
    void setLabelFunction(std::function<QString(const core::SliceMeasurement&)> label)
    {
        labelFunction_ = std::move(label);
    }

    QString caption() const override;
    void end() override { drop(); }
    bool startDrag(const SlicePointer& pressed) override;
    void drag(const SlicePointer& pointer) override;
    void finishDrag(const SlicePointer& pointer) override;
    bool click(const SlicePointer& pointer) override;
    bool doubleClick(const SlicePointer& pointer) override;
    void hover(const SlicePointer& pointer) override;
    void leave() override;
    bool takesKey(const QKeyEvent& event) const override;
    void keyPress(const QKeyEvent& event) override;
    bool undoStep() override;
    void paint(QPainter& painter, SliceView& view) const override;

signals:
    void drawn(const core::SliceMeasurement& measurement);
    void pointMoved(int measurement, int point, const Eigen::Vector3d& pointInPatient);
    void removeRequested();   ///< requests removal of the selected measurement or, without a selection, of the last one

private:
    struct DraggedPoint {
        std::size_t measurement = 0;
        std::size_t point = 0;
        Eigen::Vector3d at = Eigen::Vector3d::Zero();
        core::SliceMeasurement whole;   ///< measurement at the start of the drag
    };
    std::optional<DraggedPoint> draggableAt(const SlicePointer& pointer) const;
    bool stillExists(const DraggedPoint& dragged) const;
    bool isInShownSlice(SliceView& view) const;
    void addPoint(const SlicePointer& pointer);
    void finish();
    void drop();
    core::SliceMeasurement currentMeasurement()
        const;   ///< measurement being drawn (including the pointer position) or moved

    core::MeasurementKind kind_;
    std::function<QString(const core::SliceMeasurement&)> labelFunction_;
    core::SliceMeasurement next_;   ///< measurement being drawn, with the points set so far
    std::optional<Eigen::Vector3d> pointer_;
    std::optional<DraggedPoint> dragged_;
    bool isDrawing_ = false;   ///< true while a length is being drawn by dragging
};

}   // namespace angiopose::ui

#pragma once

#include "core/imaging/slice_measurement.h"
#include "ui/slices/slice_tool.h"

#include <functional>
#include <vector>

namespace angiopose::ui {

/// Measures in a slice, with the same interaction as MeasureTool: clicks set points, a drag draws a length at once or
/// moves an existing point; an area is closed by a click on its first point, a double click or Enter. All points belong
/// to one slice: the first click in another slice starts over.
class SliceMeasureTool : public SliceTool {
    Q_OBJECT
public:
    SliceMeasureTool(core::MeasurementKind kind, SliceModel& model);

    /// Sets the function that labels a measurement being drawn.
    void setWords(std::function<QString(const core::SliceMeasurement&)> words) { words_ = std::move(words); }

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
    bool takeBack() override;
    void paint(QPainter& painter, SliceView& view) const override;

signals:
    void drawn(const core::SliceMeasurement& measurement);
    void pointMoved(int measurement, int point, const Eigen::Vector3d& pointInPatient);
    void removeRequested();   ///< the selected measurement, or the last one

private:
    struct Held {
        std::size_t measurement = 0;
        std::size_t point = 0;
        Eigen::Vector3d at = Eigen::Vector3d::Zero();
        core::SliceMeasurement whole;   ///< state at the start of the drag
    };
    std::optional<Held> heldAt(const SlicePointer& pointer) const;
    bool isStillThere(const Held& held) const;
    bool isOfShownSlice(SliceView& view) const;
    void addPoint(const SlicePointer& pointer);
    void finish();
    void drop();
    core::SliceMeasurement seen() const;   ///< measurement being drawn (with the mouse position) or moved

    core::MeasurementKind kind_;
    std::function<QString(const core::SliceMeasurement&)> words_;
    core::SliceMeasurement next_;   ///< points set so far
    std::optional<Eigen::Vector3d> mouse_;
    std::optional<Held> held_;
    bool isDrawing_ = false;   ///< drawing a length by dragging
};

}   // namespace angiopose::ui

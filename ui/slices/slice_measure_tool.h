#pragma once

#include "core/imaging/slice_measurement.h"
#include "ui/slices/slice_tool.h"

#include <functional>
#include <vector>

namespace angiopose::ui {

/// Measuring tool for slices, operated like MeasureTool: clicks set points, and a drag draws a whole length or moves an
/// existing point; a click on its first point, a double-click or Enter closes an area. All points lie in one slice: a
/// click in another slice starts over.
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
    void removeRequested();   ///< requests removal of the selected measurement, or of the last one without a selection

private:
    struct Held {
        std::size_t measurement = 0;
        std::size_t point = 0;
        Eigen::Vector3d at = Eigen::Vector3d::Zero();
        core::SliceMeasurement whole;   ///< measurement at the start of the drag
    };
    std::optional<Held> heldAt(const SlicePointer& pointer) const;
    bool isStillThere(const Held& held) const;
    bool isOfShownSlice(SliceView& view) const;
    void addPoint(const SlicePointer& pointer);
    void finish();
    void drop();
    core::SliceMeasurement seen() const;   ///< measurement being drawn (including the pointer position) or moved

    core::MeasurementKind kind_;
    std::function<QString(const core::SliceMeasurement&)> words_;
    core::SliceMeasurement next_;   ///< measurement being drawn, with the points set so far
    std::optional<Eigen::Vector3d> mouse_;
    std::optional<Held> held_;
    bool isDrawing_ = false;   ///< a length is being drawn by dragging
};

}   // namespace angiopose::ui

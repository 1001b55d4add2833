#pragma once

#include "core/imaging/slice_measurement.h"
#include "ui/slices/slice_tool.h"

#include <functional>
#include <vector>

namespace angiopose::ui {

/// Measures in a slice, with the hand that MeasureTool has in the image: clicks set points, a drag draws a length at
/// once or moves a point of what is there; an area is closed by a click on its first point, a double click or Enter.
/// Points belong to one slice: the first click in another one begins anew.
class SliceMeasureTool : public SliceTool {
    Q_OBJECT
public:
    SliceMeasureTool(core::MeasurementKind kind, SliceModel& model);

    /// What to write beside points that are being set.
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
    void removeRequested();   ///< what is chosen, or the last

private:
    struct Held {
        std::size_t measurement = 0;
        std::size_t point = 0;
        Eigen::Vector3d at = Eigen::Vector3d::Zero();
        core::SliceMeasurement whole;   ///< as it was when it was taken hold of
    };
    std::optional<Held> heldAt(const SlicePointer& pointer) const;
    bool isStillThere(const Held& held) const;
    bool isOfShownSlice(SliceView& view) const;
    void addPoint(const SlicePointer& pointer);
    void finish();
    void drop();
    core::SliceMeasurement seen() const;   ///< being set, with the point under the mouse; or being moved

    core::MeasurementKind kind_;
    std::function<QString(const core::SliceMeasurement&)> words_;
    core::SliceMeasurement next_;   ///< its points so far
    std::optional<Eigen::Vector3d> mouse_;
    std::optional<Held> held_;
    bool isDrawing_ = false;   ///< a length by a drag
};

}   // namespace angiopose::ui

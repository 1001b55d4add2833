#pragma once

#include "app/document/case_document.h"
#include "app/editing/slice_measure_controller.h"
#include "app/showing/pose_preview.h"
#include "app/showing/view_sync.h"
#include "core/measuring/image_scale.h"
#include "ui/views/tools/measure_tool.h"
#include "ui/words/retranslation.h"

#include <array>
#include <set>

namespace angiopose::ui {
class AngiogramView;
class MeasurePanel;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Controls measurements in the shown image and in slices of the scan: the user draws, renames, moves and removes them,
/// each in one undo step; the list shows their basis. Values in the image follow the pose on screen.
class MeasureController : public QObject {
    Q_OBJECT
public:
    /// Parts of the window that the controller uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::MeasurePanel& panel;
        ui::AngiogramView& view;
        SliceMeasureController::Ui slices;
    };
    MeasureController(CaseDocument& document, const ViewSync& sync, const PosePreview& preview, const Ui& ui,
                      QObject* parent = nullptr);

signals:
    void refused(const QString& reason);

private:
    void connectTool(core::MeasurementKind kind, QAction& action);
    void connectPanel();
    void connectSlices();
    void add(core::MeasurementKind kind, const std::vector<Eigen::Vector2d>& pixels);
    void movePoint(std::size_t measurement, std::size_t point, const Eigen::Vector2d& pixel);
    void rename(std::size_t index, const QString& name);
    void remove(const std::set<int>& indices);
    void pickPlane(core::MeasurementPlane plane);
    void setPixelScale(double mmPerPx);
    void removeSelectedOrLast(int first, int end);
    void change(std::vector<core::ImageMeasurement> measurements, const ui::LocalizedText& name);
    void changeInSlices(std::vector<core::SliceMeasurement> measurements, const ui::LocalizedText& name);
    void goToSelected();
    std::set<int> selectedImageMeasurements() const;   ///< indices of selected entries of `measurements`
    std::set<int> selectedSliceMeasurements() const;   ///< indices of selected entries of `sliceMeasurements`
    void show();
    void showMarks();
    core::MeasurementPlane nextPlane() const;
    core::MeasurementContext measuredView() const;
    const std::vector<core::ImageMeasurement>& measurements() const;
    const std::vector<core::SliceMeasurement>& sliceMeasurements() const;

    CaseDocument& document_;
    const ViewSync& sync_;
    const PosePreview& preview_;
    Ui ui_;
    SliceMeasureController slices_;
    std::array<ui::MeasureTool*, 3> tools_{};   ///< indexed by core::MeasurementKind
    std::optional<core::MeasurementPlane> plane_;   ///< plane selected by the user; if not set, the best available one
};

}   // namespace angiopose::app

#pragma once

#include "app/document/case_document.h"
#include "core/imaging/slice_measurement.h"
#include "ui/panels/measure_panel.h"
#include "ui/slices/slice_measure_tool.h"

#include <set>

namespace angiopose::ui {
class CornerViews;
class SliceModel;
class SlicesPage;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Draws and shows measurements in slices of the scan. MeasureController lists them after those in the image and
/// applies the changes to the case.
class SliceMeasureController : public QObject {
    Q_OBJECT
public:
    /// Parts of the window that the controller uses.
    struct Ui {
        ui::SliceModel& slices;
        ui::SlicesPage& slicesPage;
        ui::CornerViews& corner;
    };
    SliceMeasureController(CaseDocument& document, const Ui& ui, QObject* parent = nullptr);

    void bind(core::MeasurementKind kind, QAction& action);
    std::vector<ui::MeasureRow> rows() const;
    void show(const std::set<int>& chosen);   ///< `chosen` holds indices among the slice measurements
    void goTo(int index);   ///< shows the slice of a measurement
    bool hasScan() const;

signals:
    void drawn(const core::SliceMeasurement& measurement);
    void pointMoved(int measurement, int point, const Eigen::Vector3d& pointInPatient);
    void removeRequested();

private:
    const std::vector<core::SliceMeasurement>& measurements() const;

    CaseDocument& document_;
    Ui ui_;
};

}   // namespace angiopose::app

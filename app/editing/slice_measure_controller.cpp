#include "app/editing/slice_measure_controller.h"

#include "app/words/measure_words.h"
#include "core/measuring/measure_image.h"
#include "ui/slices/corner_views.h"
#include "ui/slices/slice_model.h"
#include "ui/slices/slices_page.h"

#include <QAction>

#include <utility>

namespace angiopose::app {

using core::MeasurementKind;
using core::SliceMeasurement;

SliceMeasureController::SliceMeasureController(CaseDocument& document, const Ui& ui, QObject* parent)
    : QObject(parent), document_(document), ui_(ui)
{
}

const std::vector<SliceMeasurement>& SliceMeasureController::measurements() const
{
    return document_.current().vessels.measurements;
}

bool SliceMeasureController::hasScan() const
{
    return ui_.slices.hasScan();
}

void SliceMeasureController::bind(MeasurementKind kind, QAction& action)
{
    auto* tool = new ui::SliceMeasureTool(kind, ui_.slices);
    tool->setLabelFunction(sliceLabel);
    ui::bindSliceTool(action, ui_.slices, *tool);
    connect(tool, &ui::SliceMeasureTool::drawn, this, &SliceMeasureController::drawn);
    connect(tool, &ui::SliceMeasureTool::pointMoved, this, &SliceMeasureController::pointMoved);
    connect(tool, &ui::SliceMeasureTool::removeRequested, this, &SliceMeasureController::removeRequested);
}

std::vector<ui::MeasureRow> SliceMeasureController::rows() const
{
    const auto& scan = document_.current().vessels.scan;
    std::vector<ui::MeasureRow> rows;
    for (const SliceMeasurement& measurement : measurements()) {
        rows.push_back(sliceRow(measurement, scan ? &scan->geometry : nullptr));
    }
    return rows;
}

void SliceMeasureController::show(const std::set<int>& chosen)
{
    std::vector<ui::LabeledMeasurement> labeled;
    for (std::size_t i = 0; i < measurements().size(); ++i) {
        const SliceMeasurement& each = measurements()[i];
        labeled.push_back({each, sliceLabel(each), chosen.contains(static_cast<int>(i))});
    }
    ui_.slices.setMeasurements(std::move(labeled));
}

void SliceMeasureController::goTo(int index)
{
    const auto at = static_cast<std::size_t>(index);
    if (!hasScan() || at >= measurements().size()) {
        return;
    }
    const SliceMeasurement& measurement = measurements()[at];
    if (!ui_.slicesPage.isVisible()) {
        ui_.corner.showPlane(measurement.plane);
    }
    ui_.slices.setCrosshair(core::centerOf(measurement));
}

}   // namespace angiopose::app

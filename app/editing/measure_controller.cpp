#include "app/editing/measure_controller.h"

#include "app/document/edit_case.h"
#include "app/words/measure_words.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/measure_panel.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tools/bind_tool.h"

#include <algorithm>
#include <utility>

namespace angiopose::app {

using core::ImageMeasurement;
using core::MeasurementKind;
using core::MeasurementPlane;
using core::SliceMeasurement;

namespace {

QString editText(MeasurementKind kind)
{
    return kind == MeasurementKind::Length  ? MeasureController::tr("Measure length")
           : kind == MeasurementKind::Angle ? MeasureController::tr("Measure angle")
                                            : MeasureController::tr("Measure area");
}

}   // namespace

MeasureController::MeasureController(CaseDocument& document, const ViewSync& sync, const PosePreview& preview,
                                     const Ui& ui, QObject* parent)
    : QObject(parent), document_(document), sync_(sync), preview_(preview), ui_(ui), slices_(document, ui.slices)
{
    connectTool(MeasurementKind::Length, *ui_.actions[ui::Command::MeasureLength]);
    connectTool(MeasurementKind::Angle, *ui_.actions[ui::Command::MeasureAngle]);
    connectTool(MeasurementKind::Area, *ui_.actions[ui::Command::MeasureArea]);
    connectPanel();
    connectSlices();
    connect(&document_, &CaseDocument::changed, this, &MeasureController::show);
    connect(&preview_, &PosePreview::changed, this, &MeasureController::show);
    connect(&sync_, &ViewSync::frameShown, this, &MeasureController::show);
    ui::keepTranslated(this, [this] { show(); });
}

void MeasureController::connectTool(MeasurementKind kind, QAction& action)
{
    auto* tool = new ui::MeasureTool(kind, ui_.view);
    tools_[static_cast<std::size_t>(kind)] = tool;
    tool->setLabelFunction([this, kind](const std::vector<Eigen::Vector2d>& pixels) {
        return measureLabel({kind, nextPlane(), pixels, sync_.shownFrame(), {}}, measuredView());
    });
    ui::bindTool(action, ui_.view, *tool);
    slices_.bind(kind, action);
    ui_.panel.bindMode(kind, action);
    connect(&action, &QAction::toggled, this, [this, &action](bool on) {
        if (on && !document_.current().shown().angiogram && !slices_.hasScan()) {
            action.setChecked(false);
            emit refused(tr("Open an angiogram or a scan first."));
        }
    });
    connect(tool, &ui::MeasureTool::drawn, this,
            [this, kind](const std::vector<Eigen::Vector2d>& pixels) { add(kind, pixels); });
    connect(tool, &ui::MeasureTool::pointMoved, this, [this](int measurement, int point, const Eigen::Vector2d& pixel) {
        movePoint(static_cast<std::size_t>(measurement), static_cast<std::size_t>(point), pixel);
    });
    connect(tool, &ui::MeasureTool::removeRequested, this,
            [this] { removeSelectedOrLast(0, static_cast<int>(measurements().size())); });
}

void MeasureController::connectPanel()
{
    const ui::MeasurePanel& panel = ui_.panel;
    connect(&panel, &ui::MeasurePanel::planePicked, this, &MeasureController::pickPlane);
    connect(&panel, &ui::MeasurePanel::scaleTyped, this, &MeasureController::setPixelScale);
    connect(&panel, &ui::MeasurePanel::selectionChanged, this, [this] {
        show();
        goToSelected();
    });
    connect(&panel, &ui::MeasurePanel::renamed, this,
            [this](int index, const QString& name) { rename(static_cast<std::size_t>(index), name); });
    connect(&panel, &ui::MeasurePanel::removeRequested, this, &MeasureController::remove);
    connect(&panel, &ui::MeasurePanel::exportRequested, ui_.actions[ui::Command::ExportMeasurements],
            &QAction::trigger);
}

void MeasureController::connectSlices()
{
    connect(&slices_, &SliceMeasureController::drawn, this, [this](const SliceMeasurement& drawn) {
        std::vector<SliceMeasurement> all = sliceMeasurements();
        all.push_back(drawn);
        changeInSlices(std::move(all), [kind = drawn.kind] { return editText(kind); });
    });
    connect(&slices_, &SliceMeasureController::pointMoved, this,
            [this](int measurement, int point, const Eigen::Vector3d& pointInPatient) {
                std::vector<SliceMeasurement> all = sliceMeasurements();
                const auto of = static_cast<std::size_t>(measurement);
                const auto at = static_cast<std::size_t>(point);
                if (of >= all.size() || at >= all[of].pointsInPatient.size()) {
                    return;   // deleted in the meantime
                }
                all[of].pointsInPatient[at] = pointInPatient;
                changeInSlices(std::move(all), [] { return tr("Move measurement point"); });
            });
    connect(&slices_, &SliceMeasureController::removeRequested, this, [this] {
        const auto first = static_cast<int>(measurements().size());
        removeSelectedOrLast(first, first + static_cast<int>(sliceMeasurements().size()));
    });
}

const std::vector<SliceMeasurement>& MeasureController::sliceMeasurements() const
{
    return document_.current().vessels.measurements;
}

std::set<int> MeasureController::selectedImageMeasurements() const
{
    const auto count = static_cast<int>(measurements().size());
    std::set<int> indices;
    for (const int index : ui_.panel.selectedRows()) {
        if (index < count) {
            indices.insert(index);
        }
    }
    return indices;
}

std::set<int> MeasureController::selectedSliceMeasurements() const
{
    const auto count = static_cast<int>(measurements().size());
    std::set<int> indices;
    for (const int index : ui_.panel.selectedRows()) {
        if (index >= count) {
            indices.insert(index - count);
        }
    }
    return indices;
}

/// Shows the slice of the selected measurement if that was drawn in a slice.
void MeasureController::goToSelected()
{
    if (const std::set<int> indices = selectedSliceMeasurements(); indices.size() == 1) {
        slices_.goTo(*indices.begin());
    }
}

const std::vector<ImageMeasurement>& MeasureController::measurements() const
{
    return document_.current().shown().measurements;
}

core::MeasurementContext MeasureController::measuredView() const
{
    const core::Case& current = document_.current();
    return {current.shown(), current.vessels.tree.get(),
            preview_.shown() ? preview_.pose() : current.shown().cameraFromPatient};
}

MeasurementPlane MeasureController::nextPlane() const
{
    return plane_.value_or(core::preferredPlane(measuredView()));
}

void MeasureController::add(MeasurementKind kind, const std::vector<Eigen::Vector2d>& pixels)
{
    std::vector<ImageMeasurement> all = measurements();
    all.push_back({kind, nextPlane(), pixels, sync_.shownFrame(), {}});
    change(std::move(all), [kind] { return editText(kind); });
}

void MeasureController::movePoint(std::size_t measurement, std::size_t point, const Eigen::Vector2d& pixel)
{
    std::vector<ImageMeasurement> all = measurements();
    all.at(measurement).pixels.at(point) = pixel;
    change(std::move(all), [] { return tr("Move measurement point"); });
}

void MeasureController::rename(std::size_t index, const QString& name)
{
    std::vector<ImageMeasurement> all = measurements();
    std::vector<SliceMeasurement> slices = sliceMeasurements();
    const QString trimmed = name.trimmed();
    const ui::LocalizedText edit = [] { return tr("Rename measurement"); };
    const std::size_t slice = index - all.size();   // meaningful only for a measurement in a slice
    if (index < all.size() && trimmed != measureRow(all[index], measuredView()).name) {
        all[index].name = trimmed.toStdString();
        change(std::move(all), edit);
    } else if (index >= all.size() && slice < slices.size() && trimmed != slices_.rows()[slice].name) {
        slices[slice].name = trimmed.toStdString();
        changeInSlices(std::move(slices), edit);
    } else {
        show();   // restores the displayed name if only surrounding whitespace changed
    }
}

void MeasureController::remove(const std::set<int>& indices)
{
    std::vector<ImageMeasurement> images = measurements();
    std::vector<SliceMeasurement> slices = sliceMeasurements();
    int index = 0;
    const auto isGone = [&](const auto&) { return indices.contains(index++); };
    const std::size_t gone = std::erase_if(images, isGone) + std::erase_if(slices, isGone);
    if (gone > 0) {
        document_.push(std::make_unique<ChangeMeasurements>(
            document_, ChangeMeasurements::Values{std::move(images), std::move(slices)},
            [] { return tr("Remove measurement"); }));
    }
    show();
}

/// Removes the measurements selected in the list; if none are selected, removes the last one in [first, end), i.e. in
/// the image or in the slices, depending on where the key was pressed.
void MeasureController::removeSelectedOrLast(int first, int end)
{
    std::set<int> gone = ui_.panel.selectedRows();
    if (gone.empty() && end > first) {
        gone.insert(end - 1);
    }
    remove(gone);
}

void MeasureController::pickPlane(MeasurementPlane plane)
{
    plane_ = plane;
    std::vector<ImageMeasurement> all = measurements();
    for (const int index : selectedImageMeasurements()) {
        all[static_cast<std::size_t>(index)].plane = plane;
    }
    if (all != measurements()) {
        change(std::move(all), [] { return tr("Measure in another plane"); });
    }
    show();
}

void MeasureController::setPixelScale(double mmPerPx)
{
    const std::optional<double> typed = mmPerPx > 0.0 ? std::optional(mmPerPx) : std::nullopt;
    if (typed != document_.current().shown().enteredMmPerPx) {
        document_.push(std::make_unique<SetPixelScale>(document_, SetPixelScale::Values{typed},
                                                       [] { return tr("Enter image scale"); }));
    }
    show();
}

void MeasureController::change(std::vector<ImageMeasurement> measurements, const ui::LocalizedText& name)
{
    document_.push(std::make_unique<ChangeMeasurements>(
        document_, ChangeMeasurements::Values{std::move(measurements), sliceMeasurements()}, name));
    show();   // needed even if the edit was refused
}

void MeasureController::changeInSlices(std::vector<SliceMeasurement> slices, const ui::LocalizedText& name)
{
    document_.push(std::make_unique<ChangeMeasurements>(
        document_, ChangeMeasurements::Values{measurements(), std::move(slices)}, name));
    show();
}

void MeasureController::show()
{
    ui::MeasureState state;
    for (const ImageMeasurement& measurement : measurements()) {
        state.rows.push_back(measureRow(measurement, measuredView()));
    }
    const std::vector<ui::MeasureRow> sliceRows = slices_.rows();
    state.rows.insert(state.rows.end(), sliceRows.begin(), sliceRows.end());
    const std::set<int> selectedRows = selectedImageMeasurements();
    const bool isOne = !selectedRows.empty();
    state.plane = isOne ? measurements()[static_cast<std::size_t>(*selectedRows.begin())].plane : nextPlane();
    state.basis = document_.current().shown().angiogram ? planeBasis(state.plane, measuredView()) : QString();
    state.enteredMmPerPx = document_.current().shown().enteredMmPerPx;
    ui_.panel.showMeasurements(state);
    showMarks();
    slices_.show(selectedSliceMeasurements());
}

void MeasureController::showMarks()
{
    const int frame = sync_.shownFrame();
    std::vector<ui::ImageMark> marks = windowMarks(measuredView(), frame);
    std::vector<ImageMeasurement> there = measurements();
    const std::set<int> selectedRows = selectedImageMeasurements();
    std::size_t mark = 0;
    for (std::size_t i = 0; i < there.size(); ++i) {
        if (there[i].frame != frame) {
            there[i].pixels.clear();
        } else {
            marks[mark++].isSelected = selectedRows.contains(static_cast<int>(i));
        }
    }
    ui_.view.setMarks(std::move(marks));
    for (ui::MeasureTool* tool : tools_) {
        tool->showMeasurements(there);
    }
}

}   // namespace angiopose::app

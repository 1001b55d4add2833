#include "app/editing/tracing_controller.h"

#include "app/document/edit_case.h"
#include "core/messages/messages.h"
#include "core/tracing/volume/lumen/lumen_levels.h"
#include "core/tracing/volume/tracing_warnings.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/bottom_strip.h"
#include "ui/slices/slice_model.h"
#include "ui/slices/slices_page.h"
#include "ui/words/language.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <algorithm>
#include <utility>

namespace angiopose::app {
namespace {

/// Returns the range of useful thresholds: −200 to 1200 HU for CT, otherwise the range of values in the scan.
std::optional<std::pair<double, double>> thresholdRange(const ui::SliceModel& slices)
{
    if (!slices.volume()) {
        return std::nullopt;
    }
    if (slices.isHounsfield()) {
        return std::pair(-200.0, 1200.0);
    }
    const ui::GrayWindow whole = ui::autoWindow(*slices.volume());
    return std::pair(whole.level - whole.width, whole.level + whole.width);
}

std::vector<ui::SliceMark> marksAt(const std::vector<Eigen::Vector3d>& points)
{
    std::vector<ui::SliceMark> marks;
    for (std::size_t i = 0; i < points.size(); ++i) {
        marks.push_back({points[i], QString::number(i + 1)});
    }
    return marks;
}

/// Input of tracing.
struct Source {
    core::InputFile file;   ///< without a path if there is no input
    core::VesselInput input;
};

/// Returns the input from which the vessels were traced, but the scan if the mask was edited, or if the case has no
/// vessels because tracing failed when it was opened.
Source sourceOf(const core::Case& current)
{
    const bool isFromScan = current.vessels.isLumenEdited && current.vessels.scan;   // rather than from the edited mask
    if (!isFromScan && !current.vessels.file.path.empty() &&
        current.vessels.input.kind != core::VesselInputKind::Centerline) {
        return {current.vessels.file, current.vessels.input};
    }
    if ((current.vessels.tree && !isFromScan) || !current.vessels.scan) {
        return {};
    }
    core::VesselInput asVolume;
    asVolume.kind = core::VesselInputKind::Volume;
    asVolume.seriesId = current.vessels.scanSeriesId;
    return {current.vessels.scanFile, asVolume};
}

}   // namespace

TracingController::TracingController(CaseDocument& document, const Ui& ui, QObject* parent)
    : QObject(parent),
      document_(document),
      ui_(ui),
      labels_(document, ui.actions, ui.panel.labels(), ui.slices),
      thresholdJob_([this](double threshold) { ui_.panel.showAutomatic(threshold); })
{
    connectPanel();
    connect(&document, &CaseDocument::changed, this, &TracingController::updateFromDocument);
    connect(&document, &CaseDocument::stateChanged, this, [this] {
        showBlockingReason();
        if (pendingResult_ && !document_.isLocked()) {
            finish(*std::exchange(pendingResult_, std::nullopt));
        }
    });
    connect(&job_, &VesselTraceJob::progressed, this, [this](double fraction) {
        ui_.strip.showProgress(tr("Tracing the vessels of the scan… %1 %").arg(ui::numberText(100.0 * fraction, 0)),
                               fraction);
    });
    connect(&job_, &VesselTraceJob::finished, this, &TracingController::finish);
    connect(&job_, &VesselTraceJob::failed, this, [this](const core::Message& reason) {
        ended();
        emit failed(ui::messageText(reason));
    });
    connect(&job_, &VesselTraceJob::stopped, this, [this] {
        ended();
        emit traced(tr("Stopped: the vessels are unchanged"));
    });
    connect(ui_.actions[ui::Command::SlicesLarge], &QAction::toggled, this, [this](bool large) {
        setPick(ui::TracingPick::Nothing);
        if (large) {
            findThreshold();
        }
        showPreview();
    });
    connect(ui_.actions[ui::Command::TraceScan], &QAction::triggered, this, [this] {
        ui_.actions[ui::Command::SlicesLarge]->setChecked(true);
        start();
    });
    connect(&ui_.slices, &ui::SliceModel::toolChanged, this, [this] {
        if (ui_.slices.tool()) {
            endPicking();
        }
    });
    connect(&labels_, &LabelController::edited, this, &TracingController::showBlockingReason);
    ui::keepTranslated(this, [this] { updateFromDocument(); });
}

void TracingController::connectPanel()
{
    ui::TracingPanel& panel = ui_.panel;
    connect(&panel, &ui::TracingPanel::optionsEdited, this, &TracingController::setDraft);
    connect(&panel, &ui::TracingPanel::pickRequested, this, &TracingController::setPick);
    connect(&panel, &ui::TracingPanel::previewChanged, this, &TracingController::showPreview);
    connect(&panel, &ui::TracingPanel::pointSelected, &ui_.slices, &ui::SliceModel::setCrosshair);
    connect(&panel, &ui::TracingPanel::traceRequested, this, &TracingController::start);
    connect(&panel, &ui::TracingPanel::stopRequested, this, &TracingController::stop);
    connect(&panel, &ui::TracingPanel::falseLumenRequested, this, [this] {
        if (falseLumen_) {
            ui_.slices.setCrosshair(*falseLumen_);
        }
    });
    connect(&panel, &ui::TracingPanel::falseLumenSeedRequested, this, &TracingController::seedFalseLumen);
    connect(&ui_.strip, &ui::BottomStrip::stopRequested, this, &TracingController::stop);
    for (const core::BodyPlane plane : core::bodyPlanes) {
        connect(&ui_.slicesPage.view(plane), &ui::SliceView::pointPicked, this,
                [this](const Eigen::Vector3d& point) { addPoint(pick_, point); });
    }
}

QString TracingController::blockingReason() const
{
    const core::Case& current = document_.current();
    if (sourceOf(current).file.path.empty()) {
        return tr(
            "These vessels were not traced from an image. To trace vessels, open a scan, a segmentation or a surface.");
    }
    if (labels_.isSelectionEmpty()) {
        return tr("No label is selected. Select the labels that contain vessels.");
    }
    return document_.isLocked() ? tr("A registration is running. Stop it first.") : QString();
}

void TracingController::updateFromDocument()
{
    const core::Case& current = document_.current();
    ui::TracingPanel& panel = ui_.panel;
    const std::shared_ptr<const core::Volume> traced =
        sourceOf(current).input.kind == core::VesselInputKind::Volume ? current.vessels.scan : nullptr;
    if (traced != shownVolume_) {
        shownVolume_ = traced;
        thresholdJob_.drop();
        panel.showAutomatic(std::nullopt);
        panel.showRange(traced ? thresholdRange(ui_.slices) : std::nullopt, ui_.slices.isHounsfield());
        if (ui_.actions[ui::Command::SlicesLarge]->isChecked()) {
            findThreshold();
        }
    }
    if (current.vessels.input != shownInput_) {
        shownInput_ = current.vessels.input;
        setDraft(shownInput_.tracing);
    }
    if (current.vessels.tree != warnedTree_) {   // the warnings belong to a different tree
        ui_.panel.showFalseLumen({});
    } else if (falseLumen_) {
        ui_.panel.showFalseLumen(ui::messagesText(warnings_));
    }
    showBlockingReason();
    showPreview();
}

void TracingController::setWarnings(const core::Messages& warnings)
{
    const auto about = std::ranges::find_if(
        warnings, [](const core::Message& each) { return each.is(core::messages::possibleFalseLumen); });
    warnings_ = about == warnings.end() ? core::Messages() : core::Messages{*about};
    falseLumen_ = core::adjacentLumenPosition(warnings_);
    warnedTree_ = document_.current().vessels.tree;
    ui_.panel.showFalseLumen(ui::messagesText(warnings_));
}

/// Adds seeds in the possible false lumen and in the traced one, since only components with seeds are traced.
void TracingController::seedFalseLumen()
{
    const auto& tree = document_.current().vessels.tree;
    if (!falseLumen_ || !tree) {
        return;
    }
    core::VesselTracingOptions draft = draft_;
    if (draft.seedsInPatient.empty()) {
        Eigen::Vector3d nearest = tree->branches.front().pointsInPatient.front();
        for (const core::VesselBranch& branch : tree->branches) {
            for (const Eigen::Vector3d& point : branch.pointsInPatient) {
                nearest = (point - *falseLumen_).norm() < (nearest - *falseLumen_).norm() ? point : nearest;
            }
        }
        draft.seedsInPatient.push_back(nearest);
    }
    draft.seedsInPatient.push_back(*falseLumen_);
    setDraft(draft);
    ui_.slices.setCrosshair(*falseLumen_);
    falseLumen_.reset();
    ui_.panel.showFalseLumen({});
}

void TracingController::showBlockingReason()
{
    const QString reason = blockingReason();
    ui_.panel.showBlockingReason(reason);
    ui_.actions[ui::Command::TraceScan]->setEnabled(reason.isEmpty() && ui_.slices.hasScan());
}

void TracingController::setDraft(const core::VesselTracingOptions& draft)
{
    draft_ = draft;
    ui_.panel.showOptions(draft);
    ui_.slices.setPoints(ui::SliceMarkKind::Seed, marksAt(draft.seedsInPatient));
    ui_.slices.setPoints(ui::SliceMarkKind::Avoid, marksAt(draft.avoidInPatient));
}

void TracingController::setPick(ui::TracingPick pick)
{
    pick_ = pick;
    if (pick != ui::TracingPick::Nothing) {
        ui_.slices.setTool(nullptr);   // clicks now set points rather than using the tool
    }
    ui_.panel.showPick(pick);
}

void TracingController::addPoint(ui::TracingPick kind, const Eigen::Vector3d& pointInPatient)
{
    if (kind == ui::TracingPick::Nothing) {
        return;
    }
    core::VesselTracingOptions draft = draft_;
    (kind == ui::TracingPick::Seed ? draft.seedsInPatient : draft.avoidInPatient).push_back(pointInPatient);
    setDraft(draft);
}

void TracingController::showPreview()
{
    const ui::TracingPanel& panel = ui_.panel;
    const bool isLarge = ui_.actions[ui::Command::SlicesLarge]->isChecked();
    ui_.slices.setPreviewFrom(isLarge && panel.isPreviewWanted() ? panel.thresholdShown() : std::nullopt);
}

void TracingController::findThreshold()
{
    if (!shownVolume_ || ui_.panel.thresholdShown() || thresholdJob_.isRunning()) {
        return;
    }
    thresholdJob_.start([volume = shownVolume_](JobLink<double>&) -> core::Result<double> {
        const auto level = core::findLumenLevels(*volume, core::patientAxisOrder(volume->geometry));
        if (!level) {
            return level.error();
        }
        return level.value().threshold;
    });
}

void TracingController::start()
{
    if (isRunning() || !blockingReason().isEmpty()) {
        return;
    }
    setPick(ui::TracingPick::Nothing);
    const core::Case& current = document_.current();
    const Source source = sourceOf(current);
    source_ = source.file;
    VesselTraceRequest request{source.file.path, source.input, current.vessels.scan};
    request.input.tracing = draft_;
    request.input.labels = labels_.draft();
    startedFrom_ = document_.state();
    ui_.panel.setRunning(true);
    ui_.strip.showBusy(tr("Tracing the vessels of the scan…"));
    job_.start(std::move(request));
}

void TracingController::finish(const VesselTrace& result)
{
    ended();
    if (document_.state().caseNumber != startedFrom_.caseNumber) {
        return;   // another case has been opened in the meantime
    }
    if (document_.isLocked()) {
        pendingResult_ = result;
        return;
    }
    if (!draft_.threshold) {
        ui_.panel.showAutomatic(result.threshold);
    }
    if (!document_.push(applyTrace(document_, {source_, result.input, result.lumen, result.tree},
                                   [] { return tr("Trace vessels"); }))) {
        return;
    }
    setWarnings(result.warnings);
    const int count = static_cast<int>(result.tree->branches.size());
    QStringList notes{count == 1 ? tr("Traced: 1 branch.") : tr("Traced: %1 branches.").arg(count)};
    for (const core::Message& warning : result.warnings) {
        notes << ui::messageText(warning);
    }
    emit traced(ui::joinSentences(notes));
}

void TracingController::ended()
{
    ui_.panel.setRunning(false);
    ui_.strip.showIdle(tr("Ready"));
}

}   // namespace angiopose::app

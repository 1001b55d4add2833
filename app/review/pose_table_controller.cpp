#include "app/review/pose_table_controller.h"

#include "app/document/edit_case.h"
#include "app/words/snapshot_texts.h"
#include "core/case/registration_input.h"
#include "io/snapshot_table.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/bottom_strip.h"
#include "ui/panels/snapshot_panel.h"
#include "ui/words/message_text.h"
#include "ui/words/terms.h"

#include <algorithm>
#include <utility>

namespace angiopose::app {
namespace {

constexpr int seriesBursts =
    1 << 22;   ///< offset that separates the merge IDs of method series from those of poses and frames

/// Default methods of the comparison: that of AngioPose, a classic one, and the standard reference of the literature.
const std::vector<std::string> defaultComparedMethods{"angiopose", "dt-icp", "iterative-pnp"};

}   // namespace

PoseTableController::PoseTableController(CaseDocument& document, TargetProvider& target, SnapshotController& snapshots,
                                         ExportController& exportController, const Ui& ui, QObject* parent)
    : QObject(parent),
      document_(document),
      target_(target),
      snapshots_(snapshots),
      exportController_(exportController),
      ui_(ui),
      methodIds_(defaultComparedMethods)
{
    connect(ui_.actions[ui::Command::ComparePoses], &QAction::triggered, this, &PoseTableController::open);
    connect(&ui_.panel, &ui::SnapshotPanel::compareRequested, this, &PoseTableController::open);
    connect(&document_, &CaseDocument::changed, this, &PoseTableController::refresh);
    connect(&snapshots_, &SnapshotController::poseEvaluated, this, &PoseTableController::refresh);
    connect(&document_, &CaseDocument::stateChanged, this, &PoseTableController::storePending);
    connectJob();
}

void PoseTableController::open()
{
    if (!document_.current().vessels.tree || document_.isInTrial()) {
        ui_.strip.showStatus(tr("There are no poses to compare yet."));
        return;
    }
    if (!table_) {
        table_ = new ui::PoseTable(&ui_.dialogParent);
        connectTable();
        table_->showChosenMethods(methodIds_);
        refresh();
    }
    table_->show();
    table_->raise();
    table_->activateWindow();
}

void PoseTableController::close()
{
    if (table_) {
        table_->close();
    }
}

void PoseTableController::connectTable()
{
    ui::PoseTable* table = table_;
    connect(table, &ui::PoseTable::snapshotPicked, &snapshots_, &SnapshotController::show);
    connect(table, &ui::PoseTable::restoreRequested, &snapshots_, &SnapshotController::restore);
    connect(table, &ui::PoseTable::removeRequested, &snapshots_, &SnapshotController::remove);
    connect(table, &ui::PoseTable::textEdited, &snapshots_, &SnapshotController::change,
            Qt::QueuedConnection);   // queued, because the editor of the cell is still active
    connect(table, &ui::PoseTable::runRequested, this, &PoseTableController::run);
    connect(table, &ui::PoseTable::stopRequested, this, &PoseTableController::stop);
    connect(table, &ui::PoseTable::exportRequested, this, &PoseTableController::exportTable);
    connect(table, &ui::PoseTable::referenceRequested, this, [this](int snapshotId) {
        referenceId_ = snapshotId;
        refresh();
    });
    connect(table, &QDialog::finished, &snapshots_, &SnapshotController::showCurrentPose);
}

std::vector<core::PoseSnapshot> PoseTableController::tableEntries() const
{
    const core::Case& current = document_.current();
    core::PoseSnapshot itself;
    itself.name = tr("Current pose").toStdString();
    itself.frame = current.shown().frame;
    itself.cameraFromPatient = current.shown().cameraFromPatient;
    itself.metrics = snapshots_.metricsOfPose();
    if (current.shown().result) {
        itself.method = current.shown().result->method;
        itself.runMs = current.shown().result->time.totalMs;
    }
    std::vector<core::PoseSnapshot> all{itself};
    all.insert(all.end(), current.shown().snapshots.begin(), current.shown().snapshots.end());
    return all;
}

void PoseTableController::refresh()
{
    if (!table_ || !document_.current().vessels.tree) {
        return;
    }
    const std::vector<core::PoseSnapshot> all = tableEntries();
    const core::PoseSnapshot* reference = core::findSnapshot(all, referenceId_);
    if (!reference) {
        referenceId_ = 0;
        reference = &all.front();
    }
    const Eigen::Vector3d pivot = core::centroidInPatient(*document_.current().vessels.tree);
    std::vector<ui::PoseRow> rows;
    rows.reserve(all.size());
    for (const core::PoseSnapshot& snapshot : all) {
        rows.push_back(
            {snapshot, core::differenceBetween(reference->cameraFromPatient, snapshot.cameraFromPatient, pivot)});
    }
    table_->showRows(rows, referenceId_);
}

void PoseTableController::run(const std::vector<std::string>& methodIds)
{
    const core::Case& current = document_.current();
    if (job_.isRunning() || methodIds.empty() || document_.isInTrial() || !table_) {
        return;
    }
    if (!target_.current()) {
        table_->showIdle(target_.problem() ? ui::messageText(*target_.problem())
                                           : tr("The vessels of this frame are still being traced."));
        return;
    }
    auto input = core::makeRegistrationInput(current, *target_.current());
    if (!input) {
        table_->showIdle(ui::messageText(input.error().message));
        return;
    }
    origin_ = {document_.state().caseNumber, current.vessels.tree, current.shown().angiogram, current.shown().frame};
    methodIds_ = methodIds;
    failures_.clear();
    solvedCount_ = 0;
    ++mergeId_;
    table_->showRun(tr("Starting…"), 0.0);
    job_.start(std::move(input).value(), current.options, methodIds);
}

void PoseTableController::connectJob()
{
    connect(&job_, &MethodSeriesJob::progressed, this, [this](const QString& methodId, double progress) {
        if (table_ && job_.isRunning()) {
            table_->showRun(ui::methodName(methodId.toStdString()), progress);
        }
    });
    connect(&job_, &MethodSeriesJob::solved, this, &PoseTableController::addResult);
    connect(&job_, &MethodSeriesJob::failed, this, [this](const QString& methodId, const core::Message& reason) {
        failures_ << tr("%1: %2").arg(ui::methodName(methodId.toStdString()), ui::messageText(reason));
    });
    connect(&job_, &MethodSeriesJob::ended, this, &PoseTableController::finish);
}

void PoseTableController::addResult(const core::RegistrationResult& result)
{
    pending_.push_back(snapshotOfRun(result, origin_.frame));
    ++solvedCount_;
    storePending();
}

void PoseTableController::storePending()
{
    if (pending_.empty() || document_.isLocked() || document_.isInTrial()) {
        return;
    }
    const core::Case& current = document_.current();
    const bool stillFits = document_.state().caseNumber == origin_.caseNumber &&
                           current.vessels.tree == origin_.tree.lock() &&
                           current.shown().angiogram == origin_.angiogram.lock();
    std::vector<core::PoseSnapshot> snapshots = current.shown().snapshots;
    for (core::PoseSnapshot& solved : std::exchange(pending_, {})) {
        snapshots = core::withSnapshot(std::move(snapshots), std::move(solved));
    }
    if (stillFits) {
        document_.push(std::make_unique<ChangeSnapshots>(
            document_, ChangeSnapshots::Values{std::move(snapshots)}, [] { return tr("Run several methods"); },
            seriesBursts + mergeId_));
    }
}

void PoseTableController::finish(bool wasStopped)
{
    if (table_) {
        const QString count = solvedCount_ == 1 ? tr("1 method done") : tr("%1 methods done").arg(solvedCount_);
        table_->showIdle(wasStopped          ? tr("Stopped. %1.").arg(count)
                         : failures_.empty() ? count
                                             : failures_.join(QLatin1Char(' ')));
    }
}

void PoseTableController::exportTable()
{
    const std::vector<core::PoseSnapshot> all = tableEntries();
    const core::PoseSnapshot* reference = core::findSnapshot(all, referenceId_);
    if (!reference || !document_.current().vessels.tree) {
        return;
    }
    exportController_.askForFile(
        {tr("Export comparison"), tr("Tables (*.csv)"), QStringLiteral("poses.csv")},
        [all, chosen = *reference, pivot = core::centroidInPatient(*document_.current().vessels.tree)](
            const QString& path) { return io::writeSnapshotTable(all, chosen, pivot, path.toStdString()); });
}

}   // namespace angiopose::app

#include "app/review/blind_trial_controller.h"

#include "app/document/edit_case.h"
#include "app/messages/messages.h"
#include "app/preferences/save_folder.h"
#include "app/preferences/settings.h"
#include "app/words/snapshot_texts.h"
#include "core/case/registration_input.h"
#include "core/simulation/simulated_case.h"
#include "core/support/random.h"
#include "core/support/utc_time.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/trial_bar.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"

#include <algorithm>
#include <array>

namespace angiopose::app {
namespace {

/// Commands that would reveal how good a pose is, show another pose, or export or save the state of the trial.
constexpr std::array hiddenCommands{
    ui::Command::Register,     ui::Command::WorstBranch,     ui::Command::Replay,
    ui::Command::Swing,        ui::Command::NextSolution,    ui::Command::AcceptSolution,
    ui::Command::TakeSnapshot, ui::Command::ToggleSnapshots, ui::Command::ComparePoses,
    ui::Command::Save,         ui::Command::SaveAs,          ui::Command::ExportOverlay,
    ui::Command::ExportResult, ui::Command::ExportPose,      ui::Command::Open,
    ui::Command::OpenFolder,   ui::Command::OpenSample,      ui::Command::BlindTrial,
    ui::Command::CopyPose,     ui::Command::Landmarks,       ui::Command::RegisterLandmarks,
    ui::Command::AddView,      ui::Command::NextView,        ui::Command::TrackVessels,
    ui::Command::ExportReport, ui::Command::CloseCase};

std::uint64_t nextSeed(const std::vector<core::PoseSnapshot>& snapshots)
{
    return 1 + static_cast<std::uint64_t>(snapshots.size());
}

}   // namespace

BlindTrialController::BlindTrialController(CaseDocument& document, TargetProvider& target, const Ui& ui,
                                           QObject* parent)
    : QObject(parent), document_(document), target_(target), ui_(ui)
{
    connect(ui_.actions[ui::Command::BlindTrial], &QAction::triggered, this, &BlindTrialController::openDialog);
    connect(ui_.actions[ui::Command::FinishTrial], &QAction::triggered, this, &BlindTrialController::finish);
    connect(&ui_.bar, &ui::TrialBar::finishRequested, this, &BlindTrialController::finish);
    connect(&ui_.bar, &ui::TrialBar::abandonRequested, this, &BlindTrialController::abandon);
    connect(&evaluationJob_, &EvaluationJob::evaluated, this,
            [this](const SharedEvaluation& evaluation) { addSnapshot(evaluation->result); });
    ui_.actions[ui::Command::FinishTrial]->setEnabled(false);
}

void BlindTrialController::openDialog()
{
    const core::Case& current = document_.current();
    if (!current.vessels.tree || !current.shown().angiogram || !core::initialPoseOf(current) || document_.isLocked()) {
        emit failed(
            tr("A blind trial requires vessels, an angiogram and an initial pose. No registration may be running."));
        return;
    }
    ui::BlindTrialSetup suggested;
    const QString last = settings::observer.read();
    suggested.observer = last.isEmpty() ? observerName() : last;
    suggested.seed = nextSeed(current.shown().snapshots);
    suggested.rangeMm = settings::trialRangeMm.read();
    suggested.rangeDeg = settings::trialRangeDeg.read();
    suggested.logPath = settings::trialLog.read();
    if (suggested.logPath.isEmpty()) {
        suggested.logPath = suggestedPath(document_.path(), QStringLiteral("observer-trials.csv"));
    }
    auto* dialog = new ui::BlindTrialDialog(suggested, &ui_.dialogParent);
    connect(dialog, &ui::BlindTrialDialog::startRequested, this, &BlindTrialController::start);
    dialog->open();
}

void BlindTrialController::start(const ui::BlindTrialSetup& setup)
{
    const core::Case& current = document_.current();
    if (isRunning() || document_.isLocked() || !current.vessels.tree) {
        return;
    }
    settings::observer.write(setup.observer);
    settings::trialRangeMm.write(setup.rangeMm);
    settings::trialRangeDeg.write(setup.rangeDeg);
    settings::trialLog.write(setup.logPath);
    emit aboutToStart();

    setup_ = setup;
    caseNumber_ = document_.state().caseNumber;
    core::CounterRandom random(setup.seed);
    trial_ = {};
    trial_.startedAt = core::utcNow();
    trial_.observer = setup.observer.toStdString();
    trial_.caseTitle = current.title;
    trial_.imageSha256 = current.shown().imageFile.sha256;
    trial_.seed = setup.seed;
    trial_.rangeMm = setup.rangeMm;
    trial_.rangeDeg = setup.rangeDeg;
    trial_.centerPose = current.shown().cameraFromPatient;
    trial_.pivotInPatient = core::centroidInPatient(*current.vessels.tree);
    trial_.initialPose =
        core::displaceUniformly(trial_.centerPose, trial_.pivotInPatient, setup.rangeDeg, setup.rangeMm, random);
    document_.beginTrial(std::make_unique<StartBlindTrial>(
        document_, StartBlindTrial::Values{trial_.initialPose, trial_.initialPose, std::nullopt, {}, {}},
        [] { return tr("Blind trial"); }));
    showRunning(true);
    if (QAction* nudge = ui_.actions[ui::Command::Nudge]; !nudge->isChecked()) {
        nudge->trigger();   // starts nudge mode, in which keys move the vessels
    }
    clock_.start();
    emit started();
}

void BlindTrialController::finish()
{
    end(false);
}

void BlindTrialController::abandon()
{
    end(true);
}

void BlindTrialController::end(bool isAbandoned)
{
    if (!isRunning()) {
        return;
    }
    trial_.durationS = 1e-3 * static_cast<double>(clock_.elapsed());
    trial_.editCount = document_.trialEdits();
    trial_.isAbandoned = isAbandoned;
    trial_.frame = document_.current().shown().frame;
    trial_.finalPose = document_.current().shown().cameraFromPatient;
    document_.endTrial();
    showRunning(false);
    emit ended();
    log(trial_);
    if (!isAbandoned) {
        evaluate(trial_);
    }
}

void BlindTrialController::showRunning(bool running)
{
    if (running) {
        ui_.bar.showTrial(setup_.observer);
    } else {
        ui_.bar.hideTrial();
    }
    for (const ui::Command command : hiddenCommands) {
        ui_.actions[command]->setEnabled(!running);
    }
    ui_.actions[ui::Command::FinishTrial]->setEnabled(running);
    if (running) {
        ui_.actions[ui::Command::Landmarks]->setChecked(false);
    }
    for (QWidget* part : ui_.verdictWidgets) {
        part->setVisible(!running);
    }
}

void BlindTrialController::log(const io::ObserverTrial& trial)
{
    files_.run(
        [trial, path = setup_.logPath]() -> core::Result<QString> {
            if (const auto written = io::appendTrial(trial, path.toStdString()); !written) {
                return written.error();
            }
            return path;
        },
        [this](const core::Result<QString>& written) {
            if (written) {
                emit logged(written.value());
            } else {
                emit failed(ui::messageText(written.error().message));
            }
        });
}

void BlindTrialController::evaluate(const io::ObserverTrial& trial)
{
    const bool isSameFrame = target_.current() && trial.frame == document_.current().shown().frame;
    auto input = isSameFrame ? core::makeRegistrationInput(document_.current(), *target_.current())
                             : core::Result<core::RegistrationInput>(core::Error(messages::notShown()));
    if (input) {
        evaluationJob_.request({std::move(input).value(), trial.finalPose});
        return;
    }
    core::RegistrationResult unjudged;
    unjudged.cameraFromPatient = trial.finalPose;
    addSnapshot(unjudged);
}

void BlindTrialController::addSnapshot(const core::RegistrationResult& evaluated)
{
    if (document_.state().caseNumber != caseNumber_ || document_.isInTrial()) {
        return;   // too late for a snapshot, but the trial log already contains the result
    }
    core::PoseSnapshot snapshot;
    snapshot.name = tr("%1, blind").arg(setup_.observer).toStdString();
    snapshot.author = trial_.observer;
    snapshot.time = trial_.startedAt;
    snapshot.note = tr("Blind trial, seed %1, %2 s, %3 edits")
                        .arg(trial_.seed)
                        .arg(ui::numberText(trial_.durationS, 0))
                        .arg(trial_.editCount)
                        .toStdString();
    snapshot.frame = trial_.frame;
    snapshot.cameraFromPatient = evaluated.cameraFromPatient;
    if (evaluated.metrics.medianPx > 0.0) {
        snapshot.metrics = core::metricsOf(evaluated);
    }
    document_.push(std::make_unique<ChangeSnapshots>(
        document_,
        ChangeSnapshots::Values{core::withSnapshot(document_.current().shown().snapshots, std::move(snapshot))},
        [] { return tr("Save blind trial"); }));
}

}   // namespace angiopose::app

#include "app/case_controller.h"

#include "app/files/recent_cases.h"
#include "app/step_states.h"
#include "app/texts/case_texts.h"
#include "app/texts/overlay_picture.h"
#include "ui/dialogs/message_dialog.h"
#include "ui/views/angiogram_view.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>

#include <algorithm>

// What the window says about the case: title, steps, geometry, judgement, notes and problems.

namespace app {
namespace {

using namespace std::chrono_literals;

ui::JudgedPose judgedPose(const core::RegistrationCase& current, const Judgement& judgement,
                          const core::ProjectionCamera& camera)
{
    const double depthMm = (current.cameraFromPatient * core::centroidInPatient(*current.tree)).z();
    const double shownDepthMm = std::max(depthMm, core::minProjectableDepthMm);
    ui::JudgedPose judged;
    judged.source = current.result ? ui::PoseSource::Run : ui::PoseSource::Edited;
    judged.result = judgement.result;
    if (current.result) {
        // The run knows more than a second look at its pose: other solutions, why it stopped, how long it took.
        judged.result.warnings = current.result->warnings;
        judged.result.trustworthy = current.result->trustworthy;
        judged.result.uncertainty = current.result->uncertainty;
        judged.result.stopReason = current.result->stopReason;
        judged.result.time = current.result->time;
    }
    judged.millimetresPerPixel = core::millimetresPerPixel(camera, shownDepthMm);
    judged.scaleMaximumMm = residualScaleMaximumPx(camera, shownDepthMm) * judged.millimetresPerPixel;
    for (const auto& [branchId, distancesPx] : judgement.residualPx) {
        if (std::ranges::find(current.excludedBranchIds, branchId) != current.excludedBranchIds.end()) {
            continue;
        }
        for (const double distancePx : distancesPx) {
            judged.residualsMm.push_back(distancePx * judged.millimetresPerPixel);
        }
    }
    return judged;
}

QString studyLine(const core::RegistrationCase& current)
{
    if (!current.angiogram) {
        return {};
    }
    const core::StudyIdentity& identity = current.angiogram->identity;
    QStringList parts;
    for (const std::string& part : {identity.studyDate, identity.modality}) {
        if (!part.empty()) {
            parts << QString::fromStdString(part);
        }
    }
    const int count = current.angiogram->frameCount();
    parts << (count > 1 ? CaseController::tr("%1 frames").arg(count) : CaseController::tr("1 frame"));
    return parts.join(QStringLiteral(" · "));
}

}   // namespace

void CaseController::showJudgement()
{
    const core::RegistrationCase& current = document_.current();
    window_.result().showHistory(current.result ? current.result->history : std::vector<core::IterationReport>{});
    const auto camera = core::cameraOf(current);
    if (!judgement_ || !camera || !current.tree || registration_.isRunning()) {
        look_.knowResiduals({}, 0.0);
        replay_.knowUncertainty(std::nullopt);
        sync_.showJudgement(nullptr);
        if (!registration_.isRunning()) {
            window_.result().showNothing(target_.problem().isEmpty() ? tr("nothing to judge yet") : target_.problem());
        }
        return;
    }
    sync_.showJudgement(judgement_);
    ui::JudgedPose judged = judgedPose(current, *judgement_, camera.value());
    if (!current.result && !isMovedFromStart()) {
        judged.source = ui::PoseSource::Start;
    }
    look_.knowResiduals(judged.result.branches, judged.millimetresPerPixel);
    replay_.knowUncertainty(judged.result.uncertainty);
    window_.result().showJudgement(judged, *current.tree);
}

bool CaseController::isMovedFromStart() const
{
    const auto offset = pose_.currentOffset();
    return offset && std::ranges::any_of(ui::poseAxes, [&offset](ui::PoseAxis axis) {
               return std::abs(ui::valueOf(*offset, axis)) > 1e-6;
           });
}

void CaseController::showTitle()
{
    const QString name = QString::fromStdString(document_.current().title);
    const QString star = document_.isModified() ? QStringLiteral("*") : QString();
    const QString shown = document_.isEmpty() ? QString() : (name.isEmpty() ? tr("Untitled case") : name) + star;
    window_.setWindowTitle(shown.isEmpty() ? tr("AngioPose · not for clinical use")
                                           : tr("%1 · AngioPose · not for clinical use").arg(shown));
    window_.header().showTitle(shown);
    window_.header().showStudy(studyLine(document_.current()));
    window_.strip().showSaveState(save_.saveState());
}

void CaseController::showSteps()
{
    const core::RegistrationCase& current = document_.current();
    StepFacts facts;
    facts.targetProblem = target_.problem();
    facts.isTracing = target_.isTracing();
    facts.isRunning = registration_.isRunning();
    facts.poseEdited = isMovedFromStart();
    facts.exported = exported_;
    window_.steps().showStates(stepStates(current, facts));
}

void CaseController::showGeometry()
{
    const core::RegistrationCase& current = document_.current();
    ui::GeometryState state;
    state.cArm = current.cArm;
    state.cameraOverride = current.cameraOverride;
    if (current.angiogram) {
        const auto camera = core::cameraOf(current);
        if (!camera) {
            state.missing = QString::fromStdString(camera.error().message);
        } else if (current.tree) {
            if (const auto start = core::startPoseOf(current); !start) {
                state.missing = QString::fromStdString(start.error().message);
            }
            const double depthMm = (current.cameraFromPatient * core::centroidInPatient(*current.tree)).z();
            if (depthMm > core::minProjectableDepthMm) {
                state.vesselMmPerPx = core::millimetresPerPixel(camera.value(), depthMm);
            }
        }
        state.contradictions = core::findContradictions(current.cArm);
    }
    window_.geometryPanel().showGeometry(state);
}

void CaseController::showNote(const QString& note)
{
    if (registration_.isRunning() || open_.isLoading()) {
        window_.strip().showStatus(note);
        return;
    }
    window_.strip().showIdle(note);
    noteTimer_.start(6s);
}

void CaseController::showProblem(const QString& heading, const QString& reason, const QStringList& paths)
{
    QStringList details{tr("AngioPose %1").arg(QCoreApplication::applicationVersion()),
                        QDateTime::currentDateTime().toString(Qt::ISODate)};
    details += paths;
    ui::MessageDialog::show({heading, reason, details.join(QLatin1Char('\n'))}, &window_);
}

void CaseController::fillRecent()
{
    QMenu* menu = window_.actions().recentMenu();
    menu->clear();
    for (const QString& path : recentCases()) {
        const QFileInfo file(path);
        const bool missing = !file.exists();
        QAction* action = menu->addAction(missing ? tr("%1 (missing)").arg(file.fileName()) : file.fileName());
        action->setToolTip(path);
        action->setEnabled(!missing);
        connect(action, &QAction::triggered, this, [this, path] { open({path}); });
    }
    menu->setEnabled(!menu->isEmpty());
    window_.welcome().showRecent(recentCases());
}

}   // namespace app

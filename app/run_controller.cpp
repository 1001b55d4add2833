#include "app/run_controller.h"

#include "app/document/edit_case.h"
#include "core/registration/deformation_check.h"
#include "core/registration/judging/unopacified_branches.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/bottom_strip.h"
#include "ui/panels/geometry_panel.h"
#include "ui/panels/pose_panel.h"
#include "ui/panels/registration_panel.h"
#include "ui/panels/result_panel.h"
#include "ui/views/tree_view.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"
#include "ui/words/terms.h"

#include <algorithm>

namespace angiopose::app {

RunController::RunController(const Parts& parts, QObject* parent) : QObject(parent), parts_(parts)
{
    connectCommands();
    connectRun();
}

void RunController::show()
{
    parts_.panel.showOptions(parts_.document.current().options);
    parts_.panel.showBlockingReason(parts_.registration.notReadyReason());
}

void RunController::connectCommands()
{
    const ui::RegistrationPanel& panel = parts_.panel;
    const ui::WindowActions& actions = parts_.actions;
    connect(&panel, &ui::RegistrationPanel::registerRequested, &parts_.registration, &RegistrationController::start);
    connect(&panel, &ui::RegistrationPanel::stopRequested, &parts_.registration, &RegistrationController::stop);
    connect(&panel, &ui::RegistrationPanel::optionsEdited, this, &RunController::changeOptions);
    connect(&panel, &ui::RegistrationPanel::allViewsToggled, &parts_.registration,
            &RegistrationController::setAllViews);
    connect(actions[ui::Command::Register], &QAction::triggered, this, &RunController::start);
    connect(actions[ui::Command::Stop], &QAction::triggered, &parts_.registration, &RegistrationController::stop);
    connect(&parts_.strip, &ui::BottomStrip::stopRequested, this, &RunController::stop);
}

void RunController::connectRun()
{
    const RegistrationController& run = parts_.registration;
    connect(&run, &RegistrationController::runningChanged, this, &RunController::showRunning);
    connect(&run, &RegistrationController::tracingStarted, this,
            [this] { parts_.strip.showBusy(tr("Tracing the vessels of this frame…")); });
    connect(&run, &RegistrationController::progressed, this, &RunController::showProgress);
    connect(&run, &RegistrationController::finished, this, &RunController::showFinished);
    connect(&parts_.preview, &PosePreview::changed, this, [this] {
        parts_.result.setDimmed(parts_.preview.shown() && parts_.preview.colors() == ResidualColors::Hidden);
    });
    connect(&run, &RegistrationController::failed, this, [this](const QString& reason) {
        parts_.notifications.showProblem(tr("Could not start the registration"), reason);
    });
}

void RunController::start()
{
    if (!parts_.registration.isRunning()) {
        parts_.review.stopMotion();
        parts_.registration.start();
    }
}

/// Cancels the task shown in the strip: registration or the loading of files.
void RunController::stop()
{
    parts_.registration.stop();
    parts_.session.abandonLoading();
}

void RunController::changeOptions(const core::RegistrationOptions& options, const ui::LocalizedText& label)
{
    parts_.document.push(std::make_unique<ChangeOptions>(parts_.document, ChangeOptions::Values{options},
                                                         [label] { return tr("Change option “%1”").arg(label()); }));
}

void RunController::showRunning(bool running)
{
    parts_.review.stopMotion();
    parts_.panel.setRunning(running);
    parts_.posePanel.setEnabled(!running);
    parts_.geometryPanel.setEnabled(!running);
    if (running) {
        parts_.result.startRun();
        parts_.sync.showAssessment(nullptr);
    } else {
        parts_.preview.end(PreviewSource::Run);
        parts_.strip.showIdle(tr("Ready"));
        parts_.evaluation.show();
    }
}

void RunController::showProgress(const RunReport& report)
{
    if (!parts_.registration.isRunning()) {
        return;   // late report of a registration that has already ended
    }
    const core::IterationReport& step = report.iteration;
    if (report.isOfShownView) {
        parts_.preview.show(PreviewSource::Run, step.cameraFromPatient, ResidualColors::Visible);
        parts_.result.showProgress(step);
    }
    parts_.strip.showProgress(tr("Registering: %1 · %2 % · %3 px")
                                  .arg(ui::termText(step.stage))
                                  .arg(ui::numberText(100.0 * step.progress, 0))
                                  .arg(ui::numberText(step.medianDistancePx, 1)),
                              step.progress);
}

void RunController::showFinished(const core::RegistrationResult& result)
{
    parts_.treeView.scene().reframe();
    parts_.treeView.requestRender();
    const QString reported = finishedText(result);
    if (result.trustworthy || result.stopReason == core::StopReason::StoppedByUser) {
        parts_.notifications.showNote(reported);
    } else {
        parts_.notifications.showWarnings(reported);
    }
}

QString RunController::finishedText(const core::RegistrationResult& result)
{
    const QString median = ui::numberText(result.metrics.medianMm, 2);
    if (result.stopReason == core::StopReason::StoppedByUser) {
        return tr("Stopped, NOT RELIABLE: the best pose so far is kept; Undo restores the previous pose");
    }
    if (result.trustworthy) {
        return tr("Registered: median %1 mm").arg(median);
    }
    const auto reason = std::ranges::find_if(result.warnings, core::lowersConfidence);
    const auto reported = reason == result.warnings.end() ? result.warnings.begin() : reason;
    return tr("NOT RELIABLE · median %1 mm over %2 % of the tree")
               .arg(median, ui::numberText(100.0 * core::assessedFraction(result), 0)) +
           (reported == result.warnings.end() ? QString() : QStringLiteral(": ") + ui::messageText(*reported));
}

}   // namespace angiopose::app

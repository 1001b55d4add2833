#include "app/run_controller.h"

#include "app/document/edit_case.h"
#include "core/registration/deformation_check.h"
#include "core/registration/judging/unfilled_branches.h"
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

RunController::RunController(const Parts& parts, QObject* parent) : QObject(parent), on_(parts)
{
    connectCommands();
    connectRun();
}

void RunController::show()
{
    on_.panel.showOptions(on_.document.current().options);
    on_.panel.showReady(on_.registration.whyNotReady());
}

void RunController::connectCommands()
{
    const ui::RegistrationPanel& panel = on_.panel;
    const ui::WindowActions& actions = on_.actions;
    connect(&panel, &ui::RegistrationPanel::registerRequested, &on_.registration, &RegistrationController::start);
    connect(&panel, &ui::RegistrationPanel::stopRequested, &on_.registration, &RegistrationController::stop);
    connect(&panel, &ui::RegistrationPanel::optionsEdited, this, &RunController::changeOptions);
    connect(&panel, &ui::RegistrationPanel::allViewsToggled, &on_.registration, &RegistrationController::setAllViews);
    connect(actions[ui::Command::Register], &QAction::triggered, this, &RunController::start);
    connect(actions[ui::Command::Stop], &QAction::triggered, &on_.registration, &RegistrationController::stop);
    connect(&on_.strip, &ui::BottomStrip::stopRequested, this, &RunController::stop);
}

void RunController::connectRun()
{
    const RegistrationController& run = on_.registration;
    connect(&run, &RegistrationController::runningChanged, this, &RunController::showRunning);
    connect(&run, &RegistrationController::tracingStarted, this,
            [this] { on_.strip.showBusy(tr("Tracing the vessels of this frame…")); });
    connect(&run, &RegistrationController::advanced, this, &RunController::showProgress);
    connect(&run, &RegistrationController::finished, this, &RunController::showFinished);
    connect(&on_.preview, &PosePreview::changed, this,
            [this] { on_.result.setDimmed(on_.preview.shown() && on_.preview.colors() == ResidualColors::Hidden); });
    connect(&run, &RegistrationController::failed, this, [this](const QString& reason) {
        on_.notifications.showProblem(tr("Could not start the registration"), reason);
    });
}

void RunController::start()
{
    if (!on_.registration.isRunning()) {
        on_.review.stopMotion();
        on_.registration.start();
    }
}

/// Stops the task shown in the strip: a registration or the loading of files.
void RunController::stop()
{
    on_.registration.stop();
    on_.session.abandonLoading();
}

void RunController::changeOptions(const core::RegistrationOptions& options, const ui::Words& label)
{
    on_.document.push(std::make_unique<ChangeOptions>(on_.document, ChangeOptions::Values{options},
                                                      [label] { return tr("Change option “%1”").arg(label()); }));
}

void RunController::showRunning(bool running)
{
    on_.review.stopMotion();
    on_.panel.setRunning(running);
    on_.posePanel.setEnabled(!running);
    on_.geometryPanel.setEnabled(!running);
    if (running) {
        on_.result.startRun();
        on_.sync.showJudgement(nullptr);
    } else {
        on_.preview.end(PreviewOf::Run);
        on_.strip.showIdle(tr("Ready"));
        on_.judgement.show();
    }
}

void RunController::showProgress(const RunReport& report)
{
    if (!on_.registration.isRunning()) {
        return;   // late report of a registration that has already ended
    }
    const core::IterationReport& step = report.iteration;
    if (report.isOfShownView) {
        on_.preview.show(PreviewOf::Run, step.cameraFromPatient, ResidualColors::Kept);
        on_.result.showProgress(step);
    }
    on_.strip.showProgress(tr("Registering: %1 · %2 % · %3 px")
                               .arg(ui::termText(step.stage))
                               .arg(ui::numberText(100.0 * step.progress, 0))
                               .arg(ui::numberText(step.medianDistancePx, 1)),
                           step.progress);
}

void RunController::showFinished(const core::RegistrationResult& result)
{
    on_.treeView.scene().frameAgain();
    on_.treeView.requestRender();
    const QString reported = finishedText(result);
    if (result.trustworthy || result.stopReason == core::StopReason::StoppedByUser) {
        on_.notifications.showNote(reported);
    } else {
        on_.notifications.showWarnings(reported);
    }
}

QString RunController::finishedText(const core::RegistrationResult& result)
{
    const QString median = ui::numberText(result.metrics.medianMm, 2);
    if (result.stopReason == core::StopReason::StoppedByUser) {
        return tr("Stopped, NOT RELIABLE: the best pose so far is kept; Undo restores the previous one");
    }
    if (result.trustworthy) {
        return tr("Registered: median %1 mm").arg(median);
    }
    const auto reason = std::ranges::find_if(result.warnings, core::speaksAgainstTrust);
    const auto reported = reason == result.warnings.end() ? result.warnings.begin() : reason;
    return tr("NOT RELIABLE · median %1 mm over %2 % of the tree")
               .arg(median, ui::numberText(100.0 * core::judgedShare(result), 0)) +
           (reported == result.warnings.end() ? QString() : QStringLiteral(": ") + ui::messageText(*reported));
}

}   // namespace angiopose::app

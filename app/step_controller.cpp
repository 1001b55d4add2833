#include "app/step_controller.h"

#include "app/step_states.h"
#include "ui/main_window.h"
#include "ui/places/folding_column.h"
#include "ui/words/message_text.h"

#include <QTimer>

namespace angiopose::app {

StepController::StepController(const Parts& parts, QObject* parent) : QObject(parent), on_(parts)
{
    connect(&on_.document, &CaseDocument::changed, this, [this] { exported_ = false; });
    connect(&on_.session, &SessionController::exported, this, [this] {
        exported_ = true;
        show();
    });
    connect(&on_.tree, &TreeActions::adviceChanged, this, &StepController::show);
    connect(&on_.registration, &RegistrationController::runningChanged, this, &StepController::show);
    connect(&on_.registration, &RegistrationController::finished, this, [this] {
        on_.window.steps().showCurrent(ui::Step::Review);
        if (!on_.window.isOneAlone() && !on_.window.column(ui::ColumnSide::Right).isFolded()) {
            QTimer::singleShot(0, &on_.window, [this] { on_.window.focusStep(ui::Step::Review); });
        }
    });
    connect(&on_.window.steps(), &ui::StepBar::stepClicked, this, &StepController::goTo);
}

void StepController::show()
{
    StepFacts facts;
    facts.targetProblem = ui::messageText(on_.target.problem());
    facts.targetWarning = on_.target.trace() ? ui::messagesText(on_.target.trace()->warnings) : QString();
    facts.isTracing = on_.target.isTracing();
    facts.isRunning = on_.registration.isRunning();
    facts.poseEdited = on_.pose.isMovedFromStart();
    facts.exported = exported_;
    facts.treePieces = on_.tree.advice().pieceCount();
    on_.window.steps().showStates(stepStates(on_.document.current(), facts));
}

/// Goes to a step, or opens the file dialog if the input of the step is missing.
void StepController::goTo(ui::Step step)
{
    const core::Case& current = on_.document.current();
    const bool asks = (step == ui::Step::Vessels && !current.vessels.tree) ||
                      (step == ui::Step::Angiogram && !current.shown().angiogram);
    if (asks && !on_.session.isLoading()) {
        on_.window.actions()[ui::Command::Open]->trigger();
    } else {
        emit wentTo(step);
        QTimer::singleShot(
            0, &on_.window,   // deferred until the layout has changed, to split one long event into two short ones
            [this, step] { on_.window.focusStep(step); });
    }
}

}   // namespace angiopose::app

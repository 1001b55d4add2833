#include "app/step_controller.h"

#include "app/step_states.h"
#include "ui/main_window.h"
#include "ui/places/folding_column.h"
#include "ui/words/message_text.h"

#include <QTimer>

namespace angiopose::app {

StepController::StepController(const Parts& parts, QObject* parent) : QObject(parent), parts_(parts)
{
    connect(&parts_.document, &CaseDocument::changed, this, [this] { isExported_ = false; });
    connect(&parts_.session, &SessionController::exported, this, [this] {
        isExported_ = true;
        show();
    });
    connect(&parts_.tree, &TreeActions::gapsChanged, this, &StepController::show);
    connect(&parts_.registration, &RegistrationController::runningChanged, this, &StepController::show);
    connect(&parts_.registration, &RegistrationController::finished, this, [this] {
        parts_.window.steps().showCurrent(ui::Step::Review);
        if (!parts_.window.isViewMaximized() && !parts_.window.column(ui::ColumnSide::Right).isFolded()) {
            QTimer::singleShot(0, &parts_.window, [this] { parts_.window.focusStep(ui::Step::Review); });
        }
    });
    connect(&parts_.window.steps(), &ui::StepBar::stepClicked, this, &StepController::goTo);
}

void StepController::show()
{
    StepInputs inputs;
    inputs.targetProblem = ui::messageText(parts_.target.problem());
    inputs.targetWarning = parts_.target.trace() ? ui::messagesText(parts_.target.trace()->warnings) : QString();
    inputs.isTracing = parts_.target.isTracing();
    inputs.isRunning = parts_.registration.isRunning();
    inputs.poseEdited = parts_.pose.differsFromInitialPose();
    inputs.exported = isExported_;
    inputs.treePieces = parts_.tree.gapFinder().pieceCount();
    parts_.window.steps().showStates(stepStates(parts_.document.current(), inputs));
}

/// Goes to a step, or opens the file dialog if the step's input is missing.
void StepController::goTo(ui::Step step)
{
    const core::Case& current = parts_.document.current();
    const bool asks = (step == ui::Step::Vessels && !current.vessels.tree) ||
                      (step == ui::Step::Angiogram && !current.shown().angiogram);
    if (asks && !parts_.session.isLoading()) {
        parts_.window.actions()[ui::Command::Open]->trigger();
    } else {
        emit stepSelected(step);
        QTimer::singleShot(
            0, &parts_.window,   // deferred until the layout has changed, which splits one long event in two
            [this, step] { parts_.window.focusStep(step); });
    }
}

}   // namespace angiopose::app

#pragma once

#include "app/document/case_document.h"
#include "app/editing/pose_controller.h"
#include "app/editing/tree_actions.h"
#include "app/files/session_controller.h"
#include "app/registration/registration_controller.h"
#include "app/registration/target_provider.h"
#include "ui/panels/step_bar.h"

#include <QObject>

namespace angiopose::ui {
class MainWindow;
}

namespace angiopose::app {

/// Manages the step bar: shows which steps are complete, and goes to a step when the user clicks it. Uses the whole
/// window because a step may lead to any part of it.
class StepController : public QObject {
    Q_OBJECT
public:
    /// Objects that determine the states of the steps.
    struct Parts {
        CaseDocument& document;
        TargetProvider& target;
        const PoseController& pose;
        RegistrationController& registration;
        TreeActions& tree;
        SessionController& session;
        ui::MainWindow& window;
    };
    explicit StepController(const Parts& parts, QObject* parent = nullptr);

    void show();

signals:
    void stepSelected(ui::Step step);   ///< emitted when the user selects a step, before its part of the window appears

private:
    void goTo(ui::Step step);

    Parts parts_;
    bool isExported_ = false;   ///< true if the current state of the case has been exported
};

}   // namespace angiopose::app

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

/// The step bar: what of the way to a result is done, and where a click on a step leads. Has the whole window: a step
/// may lead to any part of it.
class StepController : public QObject {
    Q_OBJECT
public:
    /// What the steps tell about.
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
    void wentTo(ui::Step step);   ///< by the user, before its part of the window is shown

private:
    void goTo(ui::Step step);

    Parts on_;
    bool exported_ = false;   ///< the case as it is
};

}   // namespace angiopose::app
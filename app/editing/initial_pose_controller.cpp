#include "app/editing/initial_pose_controller.h"

#include "app/document/edit_case.h"
#include "ui/actions/window_actions.h"
#include "ui/words/message_text.h"

namespace angiopose::app {

InitialPoseController::InitialPoseController(CaseDocument& document, const ui::WindowActions& actions, QObject* parent)
    : QObject(parent), document_(document)
{
    connect(actions[ui::Command::StartFromAngles], &QAction::triggered, this, &InitialPoseController::setFromAngles);
    connect(actions[ui::Command::SetInitialPose], &QAction::triggered, this,
            &InitialPoseController::setFromCurrentPose);
}

void InitialPoseController::setFromAngles()
{
    core::View view = document_.current().shown();
    view.initialCameraFromPatient.reset();
    const auto start = core::initialPoseOf(view, document_.current().vessels);
    if (!start) {
        emit refused(ui::messageText(start.error().message));
        return;
    }
    const bool isDone = document_.push(std::make_unique<ChangeInitialPose>(
        document_, ChangeInitialPose::Values{std::nullopt, start.value(), std::nullopt, {}},
        [] { return tr("Initial pose from angles"); }));
    if (isDone) {
        emit done(tr("Initial pose from the angles, with the isocenter placed in the vessels"));
    }
}

void InitialPoseController::setFromCurrentPose()
{
    const core::Case& current = document_.current();
    if (!current.vessels.tree || !core::cameraOf(current.shown())) {
        emit refused(tr("Open vessels and an angiogram and complete the geometry first."));
        return;
    }
    const core::RigidTransform pose = current.shown().cameraFromPatient;
    const bool isDone = document_.push(std::make_unique<ChangeInitialPose>(
        document_, ChangeInitialPose::Values{pose, pose, std::nullopt, {}}, [] { return tr("Manual initial pose"); }));
    if (isDone) {
        emit done(tr("The current pose is now the initial pose"));
    }
}

}   // namespace angiopose::app

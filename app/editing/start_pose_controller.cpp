#include "app/editing/start_pose_controller.h"

#include "app/document/edit_case.h"
#include "ui/actions/window_actions.h"
#include "ui/words/message_text.h"

namespace angiopose::app {

StartPoseController::StartPoseController(CaseDocument& document, const ui::WindowActions& actions, QObject* parent)
    : QObject(parent), document_(document)
{
    connect(actions[ui::Command::StartFromAngles], &QAction::triggered, this, &StartPoseController::startFromAngles);
    connect(actions[ui::Command::StartHere], &QAction::triggered, this, &StartPoseController::startHere);
}

void StartPoseController::startFromAngles()
{
    core::View view = document_.current().shown();
    view.initialCameraFromPatient.reset();
    const auto start = core::startPoseOf(view, document_.current().vessels);
    if (!start) {
        emit refused(ui::messageText(start.error().message));
        return;
    }
    const bool isDone = document_.push(
        std::make_unique<PlaceVessels>(document_, PlaceVessels::Values{std::nullopt, start.value(), std::nullopt, {}},
                                       [] { return tr("Start pose from angles"); }));
    if (isDone) {
        emit done(tr("Start pose from the angles, the isocentre in the vessels"));
    }
}

void StartPoseController::startHere()
{
    const core::Case& current = document_.current();
    if (!current.vessels.tree || !core::cameraOf(current.shown())) {
        emit refused(tr("Vessels, angiogram and geometry come first."));
        return;
    }
    const core::RigidTransform pose = current.shown().cameraFromPatient;
    const bool isDone = document_.push(std::make_unique<PlaceVessels>(
        document_, PlaceVessels::Values{pose, pose, std::nullopt, {}}, [] { return tr("Start pose by hand"); }));
    if (isDone) {
        emit done(tr("The pose as it is has become the start pose"));
    }
}

}   // namespace angiopose::app
#include "app/review/pose_gestures.h"

#include "ui/actions/window_actions.h"
#include "ui/panels/pose_panel.h"
#include "ui/panels/registration_panel.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tools/bind_tool.h"

#include <QClipboard>
#include <QGuiApplication>

namespace angiopose::app {
namespace {

/// Formats the matrix as four rows of four numbers, for spreadsheets and scripts.
QString matrixText(const core::RigidTransform& transform)
{
    const Eigen::Matrix4d matrix = transform.matrix();
    QString text;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            text += QString::number(matrix(row, column), 'g', 12) + QLatin1Char(column < 3 ? '\t' : '\n');
        }
    }
    return text;
}

}   // namespace

PoseGestures::PoseGestures(const Parts& parts, QObject* parent)
    : QObject(parent), on_(parts), tool_(new ui::NudgeTool(parts.view))
{
    connectPanel();
    connectTool();
    connect(&on_.pose, &PoseController::previewed, this, &PoseGestures::preview);
    connect(&on_.pose, &PoseController::previewEnded, this, &PoseGestures::endPreview);
    connect(&on_.pose, &PoseController::refused, &on_.notifications, &Notifications::showNote);
}

void PoseGestures::show()
{
    on_.panel.showOffset(on_.pose.currentOffset());
    on_.panel.showLocks(on_.pose.locks());
}

void PoseGestures::connectPanel()
{
    const ui::PosePanel& panel = on_.panel;
    connect(&panel, &ui::PosePanel::offsetEdited, &on_.pose, &PoseController::setOffset);
    connect(&panel, &ui::PosePanel::locksEdited, &on_.pose, &PoseController::setLocks);
    connect(&panel, &ui::PosePanel::resetRequested, &on_.pose, &PoseController::reset);
    connect(&on_.registration, &ui::RegistrationPanel::allViewsToggled, &on_.pose, &PoseController::setMovesAllViews);
    const ui::WindowActions& actions = on_.actions;
    connect(actions[ui::Command::ResetPose], &QAction::triggered, &on_.pose, &PoseController::reset);
    connect(actions[ui::Command::CopyPose], &QAction::triggered, this, &PoseGestures::copyMatrix);
}

void PoseGestures::connectTool()
{
    QAction* nudge = on_.actions[ui::Command::Nudge];
    ui::bindTool(*nudge, on_.view, *tool_);
    connect(nudge, &QAction::toggled, this, &PoseGestures::showNudgeMode);
    connect(tool_, &ui::NudgeTool::keyNudged, this, [this](const ui::Nudge& step) {
        on_.review.stopMotion();
        on_.panel.setActiveAxis(step.axis);
        on_.pose.nudge(step);
    });
    connect(tool_, &ui::NudgeTool::dragStarted, &on_.pose, &PoseController::startDrag);
    connect(tool_, &ui::NudgeTool::dragged, &on_.pose, &PoseController::drag);
    connect(tool_, &ui::NudgeTool::dragFinished, &on_.pose, &PoseController::finishDrag);
    connect(tool_, &ui::NudgeTool::dragCancelled, &on_.pose, &PoseController::cancelDrag);
}

void PoseGestures::showNudgeMode(bool on)
{
    on_.review.stopMotion();
    on_.panel.showNudgeMode(on);
    on_.panel.setActiveAxis(std::nullopt);
    on_.notifications.showNote(on ? tr("Nudge mode: arrow keys move, drag moves or rolls, N exits")
                                  : tr("Nudge mode off"));
}

void PoseGestures::preview(const core::RigidTransform& pose)
{
    on_.preview.show(PreviewOf::Drag, pose, ResidualColors::Kept);
    on_.panel.showOffset(on_.pose.currentOffset());
    on_.judgement.judge(pose);
}

void PoseGestures::endPreview()
{
    on_.preview.end(PreviewOf::Drag);
    on_.panel.showOffset(on_.pose.currentOffset());
    on_.judgement.judge(on_.document.current().shown().cameraFromPatient);
}

void PoseGestures::copyMatrix()
{
    QGuiApplication::clipboard()->setText(matrixText(on_.document.current().shown().cameraFromPatient));
    on_.notifications.showNote(tr("Copied: camera-from-patient matrix, 4 × 4, mm"));
}

}   // namespace angiopose::app

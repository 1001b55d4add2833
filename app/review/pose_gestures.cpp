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
    : QObject(parent), parts_(parts), tool_(new ui::NudgeTool(parts.view))
{
    connectPanel();
    connectTool();
    connect(&parts_.pose, &PoseController::previewed, this, &PoseGestures::preview);
    connect(&parts_.pose, &PoseController::previewEnded, this, &PoseGestures::endPreview);
    connect(&parts_.pose, &PoseController::refused, &parts_.notifications, &Notifications::showNote);
}

void PoseGestures::show()
{
    parts_.panel.showOffset(parts_.pose.currentOffset());
    parts_.panel.showLocks(parts_.pose.locks());
}

void PoseGestures::connectPanel()
{
    const ui::PosePanel& panel = parts_.panel;
    connect(&panel, &ui::PosePanel::offsetEdited, &parts_.pose, &PoseController::setOffset);
    connect(&panel, &ui::PosePanel::locksEdited, &parts_.pose, &PoseController::setLocks);
    connect(&panel, &ui::PosePanel::resetRequested, &parts_.pose, &PoseController::reset);
    connect(&parts_.registration, &ui::RegistrationPanel::allViewsToggled, &parts_.pose,
            &PoseController::setMovesAllViews);
    const ui::WindowActions& actions = parts_.actions;
    connect(actions[ui::Command::ResetPose], &QAction::triggered, &parts_.pose, &PoseController::reset);
    connect(actions[ui::Command::CopyPose], &QAction::triggered, this, &PoseGestures::copyMatrix);
}

void PoseGestures::connectTool()
{
    QAction* nudge = parts_.actions[ui::Command::Nudge];
    ui::bindTool(*nudge, parts_.view, *tool_);
    connect(nudge, &QAction::toggled, this, &PoseGestures::showNudgeMode);
    connect(tool_, &ui::NudgeTool::keyNudged, this, [this](const ui::Nudge& step) {
        parts_.review.stopMotion();
        parts_.panel.setActiveAxis(step.axis);
        parts_.pose.nudge(step);
    });
    connect(tool_, &ui::NudgeTool::dragStarted, &parts_.pose, &PoseController::startDrag);
    connect(tool_, &ui::NudgeTool::dragged, &parts_.pose, &PoseController::drag);
    connect(tool_, &ui::NudgeTool::dragFinished, &parts_.pose, &PoseController::finishDrag);
    connect(tool_, &ui::NudgeTool::dragCancelled, &parts_.pose, &PoseController::cancelDrag);
}

void PoseGestures::showNudgeMode(bool on)
{
    parts_.review.stopMotion();
    parts_.panel.showNudgeMode(on);
    parts_.panel.setActiveAxis(std::nullopt);
    parts_.notifications.showNote(on ? tr("Nudge mode: arrow keys move, dragging moves or rolls, N exits")
                                     : tr("Nudge mode off"));
}

void PoseGestures::preview(const core::RigidTransform& pose)
{
    parts_.preview.show(PreviewSource::Drag, pose, ResidualColors::Visible);
    parts_.panel.showOffset(parts_.pose.currentOffset());
    parts_.evaluation.evaluate(pose);
}

void PoseGestures::endPreview()
{
    parts_.preview.end(PreviewSource::Drag);
    parts_.panel.showOffset(parts_.pose.currentOffset());
    parts_.evaluation.evaluate(parts_.document.current().shown().cameraFromPatient);
}

void PoseGestures::copyMatrix()
{
    QGuiApplication::clipboard()->setText(matrixText(parts_.document.current().shown().cameraFromPatient));
    parts_.notifications.showNote(tr("Copied: patient-to-camera matrix, 4 × 4, mm"));
}

}   // namespace angiopose::app

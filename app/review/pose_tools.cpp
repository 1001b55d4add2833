#include "app/review/pose_tools.h"

#include "ui/panels/landmark_panel.h"
#include "ui/panels/result_panel.h"

#include <QFileInfo>

namespace angiopose::app {

PoseTools::PoseTools(const Parts& parts, QObject* parent)
    : QObject(parent),
      solutions_(parts.document, parts.result.solutions()),
      snapshots_(parts.document, parts.preview, parts.actions, parts.snapshotPanel, parts.strip),
      table_(parts.document, parts.target, snapshots_, parts.session.exportController(),
             {parts.actions, parts.snapshotPanel, parts.strip, parts.dialogParent}),
      blindTrial_(
          parts.document, parts.target,
          {parts.actions, parts.trialBar, {&parts.snapshotPanel, &parts.result, &parts.landmarks}, parts.dialogParent}),
      auxiliary_(parts.document, parts.branches, parts.actions, parts.view, parts.dialogParent),
      plots_(parts.dialogParent, parts.session.exportController())
{
    makeExclusive(parts);
    connectTrial(parts);
    connect(&auxiliary_, &AuxiliaryController::refused, &parts.notifications, &Notifications::showNote);
}

/// Ensures that at most one alternative pose is shown at a time.
void PoseTools::makeExclusive(const Parts& parts)
{
    ReplayController* replay = &parts.replay;
    connect(&solutions_, &SolutionController::solutionSelected, replay, &ReplayController::showSolution);
    connect(&solutions_, &SolutionController::acceptRequested, replay, [replay](std::size_t index) {
        replay->showSolution(index);
        replay->acceptSolution();
    });
    connect(replay, &ReplayController::solutionChanged, &solutions_, &SolutionController::showCurrent);
    connect(replay, &ReplayController::solutionShown, &snapshots_, &SnapshotController::showCurrentPose);
    connect(&snapshots_, &SnapshotController::snapshotShown, &parts.review, &ReviewController::stopMotion);
    connect(&parts.evaluation, &EvaluationController::evaluated, &snapshots_, &SnapshotController::setEvaluation);
}

void PoseTools::connectTrial(const Parts& parts)
{
    Notifications* notifications = &parts.notifications;
    connect(&blindTrial_, &BlindTrialController::aboutToStart, this,
            [this, review = &parts.review, session = &parts.session] {
                review->stopMotion();
                table_.close();
                session->saveController().autosaveSoon();
            });
    connect(&parts.session, &SessionController::aboutToClose, &blindTrial_, &BlindTrialController::abandon);
    connect(&blindTrial_, &BlindTrialController::logged, notifications, [notifications](const QString& path) {
        notifications->showNote(tr("Logged: %1").arg(QFileInfo(path).fileName()));
    });
    connect(&blindTrial_, &BlindTrialController::failed, notifications,
            [notifications](const QString& reason) { notifications->showProblem(tr("Blind trial"), reason); });
}

}   // namespace angiopose::app

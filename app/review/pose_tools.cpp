#include "app/review/pose_tools.h"

#include "ui/panels/landmark_panel.h"
#include "ui/panels/result_panel.h"

#include <QFileInfo>

namespace angiopose::app {

PoseTools::PoseTools(const Parts& on, QObject* parent)
    : QObject(parent),
      solutions_(on.document, on.result.solutions()),
      snapshots_(on.document, on.preview, on.actions, on.snapshotPanel, on.strip),
      table_(on.document, on.target, snapshots_, on.session.exporting(),
             {on.actions, on.snapshotPanel, on.strip, on.dialogParent}),
      blindTrial_(on.document, on.target,
                  {on.actions, on.trialBar, {&on.snapshotPanel, &on.result, &on.landmarks}, on.dialogParent}),
      auxiliary_(on.document, on.branches, on.actions, on.view, on.dialogParent),
      plots_(on.dialogParent, on.session.exporting())
{
    makeExclusive(on);
    connectTrial(on);
    connect(&auxiliary_, &AuxiliaryController::refused, &on.notifications, &Notifications::showNote);
}

/// Ensures that at most one alternative pose is shown at a time.
void PoseTools::makeExclusive(const Parts& on)
{
    ReplayController* replay = &on.replay;
    connect(&solutions_, &SolutionController::solutionSelected, replay, &ReplayController::showSolution);
    connect(&solutions_, &SolutionController::acceptRequested, replay, [replay](std::size_t index) {
        replay->showSolution(index);
        replay->acceptSolution();
    });
    connect(replay, &ReplayController::solutionChanged, &solutions_, &SolutionController::showCurrent);
    connect(replay, &ReplayController::solutionShown, &snapshots_, &SnapshotController::showCurrentPose);
    connect(&snapshots_, &SnapshotController::snapshotShown, &on.review, &ReviewController::stopMotion);
    connect(&on.evaluation, &EvaluationController::evaluated, &snapshots_, &SnapshotController::setEvaluation);
}

void PoseTools::connectTrial(const Parts& on)
{
    Notifications* notifications = &on.notifications;
    connect(&blindTrial_, &BlindTrialController::aboutToStart, this,
            [this, review = &on.review, session = &on.session] {
                review->stopMotion();
                table_.close();
                session->saving().autosaveSoon();
            });
    connect(&on.session, &SessionController::aboutToClose, &blindTrial_, &BlindTrialController::abandon);
    connect(&blindTrial_, &BlindTrialController::logged, notifications, [notifications](const QString& path) {
        notifications->showNote(tr("Logged: %1").arg(QFileInfo(path).fileName()));
    });
    connect(&blindTrial_, &BlindTrialController::failed, notifications,
            [notifications](const QString& reason) { notifications->showProblem(tr("Blind trial"), reason); });
}

}   // namespace angiopose::app

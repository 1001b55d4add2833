#include "app/review/follow_controller.h"

#include "app/document/edit_case.h"
#include "core/geometry/pose_difference.h"
#include "io/pose_table.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/bottom_strip.h"
#include "ui/panels/result_panel.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"

#include <algorithm>
#include <utility>

namespace angiopose::app {
namespace {

/// Describes the periodic motion, e.g. " · breath every 3.7 s, 8.2 mm to and fro"; empty if there is none.
QString periodWords(const core::RunPeriods& periods)
{
    const auto words = [](const QString& sentence, const core::PeriodicMotion& motion) {
        return QStringLiteral(" · ") +
               sentence.arg(ui::numberText(motion.periodS, 1), ui::numberText(2.0 * motion.amplitudeMm, 1));
    };
    QString text;
    if (periods.breath) {
        text += words(FollowController::tr("breathing: period %1 s, %2 mm peak to peak"), *periods.breath);
    }
    if (periods.heart) {
        text += words(FollowController::tr("heartbeat: period %1 s, %2 mm peak to peak"), *periods.heart);
    }
    return text;
}

}   // namespace

FollowController::FollowController(const Parts& parts, QObject* parent) : QObject(parent), on_(parts)
{
    const ui::WindowActions& actions = on_.actions;
    connect(actions[ui::Command::FollowFrames], &QAction::triggered, this, &FollowController::start);
    connect(actions[ui::Command::ExportFollowed], &QAction::triggered, this, &FollowController::exportPoses);
    connect(&on_.strip, &ui::BottomStrip::stopRequested, &job_, &FollowJob::requestStop);
    connect(&on_.panel.motion(), &ui::MotionPlot::frameRequested, &on_.review, &ReviewController::showFrame);
    connect(&job_, &FollowJob::advanced, this, [this](double fraction) {
        if (job_.isRunning()) {
            on_.strip.showProgress(
                tr("Tracking the vessels through the run: %1 %").arg(ui::numberText(100.0 * fraction, 0)), fraction);
        }
    });
    connect(&job_, &FollowJob::finished, this, &FollowController::take);
    connect(&job_, &FollowJob::failed, this, [this](const core::Message& reason) {
        startedFrom_ = {};   // releases the cine run, which is large
        on_.strip.showIdle(tr("Ready"));
        on_.notifications.showProblem(tr("Could not track the vessels"), ui::messageText(reason));
    });
    connect(&on_.document, &CaseDocument::changed, this, &FollowController::followDocument);
    connect(&on_.sync, &ViewSync::frameShown, this, &FollowController::showFrame);
    followDocument();
}

QString FollowController::whyNot() const
{
    const core::Case& current = on_.document.current();
    if (on_.document.isInTrial() || on_.document.isLocked()) {
        return tr("Another task is running. Wait for it to finish.");
    }
    return !current.vessels.tree || !current.shown().angiogram ? tr("Open vessels and an angiogram first.") : QString();
}

void FollowController::start()
{
    if (job_.isRunning()) {
        return;
    }
    if (const QString why = whyNot(); !why.isEmpty()) {
        on_.notifications.showNote(why);
        return;
    }
    on_.review.stopMotion();
    startedFrom_ = on_.document.current();
    on_.strip.showBusy(tr("Tracking the vessels through the run…"));
    job_.start(startedFrom_);
}

void FollowController::take(const std::vector<core::FollowedFrame>& frames)
{
    on_.strip.showIdle(tr("Ready"));
    const core::Case startedFrom = std::exchange(startedFrom_, {});   // releases the cine run, which is large
    const core::FollowedRun run = core::followedFrom(startedFrom.shown().frame, frames);
    if (!isAsStarted(startedFrom, run)) {
        on_.notifications.showNote(tr("The vessels were moved in the meantime. Track them again."));
        return;
    }
    if (!on_.document.push(std::make_unique<KeepFollowed>(on_.document, KeepFollowed::Values{run},
                                                          [] { return tr("Track vessels through the run"); }))) {
        return;
    }
    const auto lost = std::ranges::count_if(frames, [](const auto& each) { return !each.tracked.isTrustworthy; });
    const auto count = static_cast<int>(frames.size());
    const QString followed =
        lost == 0
            ? tr("Tracked through %1 frames: scroll or play them").arg(count)
            : tr("Tracked through %1 frames; %2 of them do not show the vessels well enough").arg(count).arg(lost);
    on_.notifications.showNote(followed + periodWords(core::periodsOf(startedFrom, frames)));
}

/// Returns whether the tracked poses belong to the current vessels and cine run and start from the current pose.
bool FollowController::isAsStarted(const core::Case& started, const core::FollowedRun& run) const
{
    const core::Case& current = on_.document.current();
    const core::View& view = current.shown();
    const core::View& before = started.shown();
    const core::FollowedFrame* shown = core::findFrame(run, view.frame);
    return current.vessels.tree == started.vessels.tree && view.angiogram == before.angiogram &&
           current.vessels.excludedBranchIds == started.vessels.excludedBranchIds &&
           view.traceOptions == before.traceOptions && view.target.centerline == before.target.centerline &&
           core::cameraOf(view) && core::cameraOf(before) &&
           core::cameraOf(view).value() == core::cameraOf(before).value() &&
           (!shown || shown->tracked.cameraFromPatient.matrix() == view.cameraFromPatient.matrix());
}

void FollowController::followDocument()
{
    const core::View& view = on_.document.current().shown();
    const bool isRun = view.angiogram && view.angiogram->frameCount() > 1 && on_.document.current().vessels.tree;
    on_.actions[ui::Command::FollowFrames]->setEnabled(isRun);
    if (view.followed.frames != shown_) {
        shown_ = view.followed.frames;
        on_.preview.end(PreviewOf::Frame);
        showMotion();
    }
    on_.actions[ui::Command::ExportFollowed]->setEnabled(!frames().empty());
}

/// Shows each frame with its own pose during playback; the document already holds the pose of its own frame.
void FollowController::showFrame(int frame)
{
    on_.panel.motion().showCurrent(frame);
    if (frames().empty() || on_.document.isLocked()) {
        return;
    }
    const core::View& view = on_.document.current().shown();
    const core::FollowedFrame* followed = core::findFrame(view.followed, frame);
    if (frame == view.frame || !followed) {
        on_.preview.end(PreviewOf::Frame);
    } else {
        on_.preview.show(PreviewOf::Frame, followed->tracked.cameraFromPatient, ResidualColors::Hidden);
    }
}

void FollowController::showMotion()
{
    const core::Case& current = on_.document.current();
    const core::FollowedRun& run = current.shown().followed;
    std::vector<ui::FrameMotion> motion;
    const Eigen::Vector3d pivot =
        current.vessels.tree ? core::centroidInPatient(*current.vessels.tree) : Eigen::Vector3d::Zero();
    const core::FollowedFrame* const from = core::findFrame(run, run.fromFrame);
    for (const core::FollowedFrame& each : core::framesOf(run)) {
        const core::PoseDifference moved =
            core::differenceBetween(from ? from->tracked.cameraFromPatient : current.shown().cameraFromPatient,
                                    each.tracked.cameraFromPatient, pivot);
        motion.push_back({each.frame, moved.inPlaneMm, moved.depthMm, moved.rotationDeg, each.tracked.isTrustworthy});
    }
    on_.panel.showMotion(motion);
    on_.panel.motion().showCurrent(on_.sync.shownFrame());
}

void FollowController::exportPoses()
{
    if (frames().empty()) {
        return;
    }
    on_.exporting.askFile(
        {tr("Export tracked poses"), tr("Tables (*.csv)"), QStringLiteral("poses.csv")},
        [frames = frames()](const QString& path) { return io::writePoseTable(frames, path.toStdString()); });
}

}   // namespace angiopose::app

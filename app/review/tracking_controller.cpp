#include "app/review/tracking_controller.h"

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

/// Describes periodic motion, e.g. " · breath every 3.7 s, 8.2 mm to and fro"; empty if there is none.
QString periodWords(const core::RunPeriods& periods)
{
    const auto words = [](const QString& sentence, const core::PeriodicMotion& motion) {
        return QStringLiteral(" · ") +
               sentence.arg(ui::numberText(motion.periodS, 1), ui::numberText(2.0 * motion.amplitudeMm, 1));
    };
    QString text;
    if (periods.breathMotion) {
        text += words(TrackingController::tr("breathing: period %1 s, %2 mm peak to peak"), *periods.breathMotion);
    }
    if (periods.heartMotion) {
        text += words(TrackingController::tr("heartbeat: period %1 s, %2 mm peak to peak"), *periods.heartMotion);
    }
    return text;
}

}   // namespace

TrackingController::TrackingController(const Parts& parts, QObject* parent) : QObject(parent), parts_(parts)
{
    const ui::WindowActions& actions = parts_.actions;
    connect(actions[ui::Command::TrackVessels], &QAction::triggered, this, &TrackingController::start);
    connect(actions[ui::Command::ExportTrackedPoses], &QAction::triggered, this, &TrackingController::exportPoses);
    connect(&parts_.strip, &ui::BottomStrip::stopRequested, &job_, &TrackingJob::requestStop);
    connect(&parts_.panel.motion(), &ui::MotionPlot::frameRequested, &parts_.review, &ReviewController::showFrame);
    connect(&job_, &TrackingJob::progressed, this, [this](double fraction) {
        if (job_.isRunning()) {
            parts_.strip.showProgress(
                tr("Tracking the vessels through the run: %1 %").arg(ui::numberText(100.0 * fraction, 0)), fraction);
        }
    });
    connect(&job_, &TrackingJob::finished, this, &TrackingController::finishTracking);
    connect(&job_, &TrackingJob::failed, this, [this](const core::Message& reason) {
        startedFrom_ = {};   // releases the cine run, which is large
        parts_.strip.showIdle(tr("Ready"));
        parts_.notifications.showProblem(tr("Could not track the vessels"), ui::messageText(reason));
    });
    connect(&parts_.document, &CaseDocument::changed, this, &TrackingController::updateFromDocument);
    connect(&parts_.sync, &ViewSync::frameShown, this, &TrackingController::showFrame);
    updateFromDocument();
}

QString TrackingController::blockingReason() const
{
    const core::Case& current = parts_.document.current();
    if (parts_.document.isInTrial() || parts_.document.isLocked()) {
        return tr("Another task is running. Wait for it to finish.");
    }
    return !current.vessels.tree || !current.shown().angiogram ? tr("Open vessels and an angiogram first.") : QString();
}

void TrackingController::start()
{
    if (job_.isRunning()) {
        return;
    }
    if (const QString why = blockingReason(); !why.isEmpty()) {
        parts_.notifications.showNote(why);
        return;
    }
    parts_.review.stopMotion();
    startedFrom_ = parts_.document.current();
    parts_.strip.showBusy(tr("Tracking the vessels through the run…"));
    job_.start(startedFrom_);
}

void TrackingController::finishTracking(const std::vector<core::TrackedRunFrame>& frames)
{
    parts_.strip.showIdle(tr("Ready"));
    const core::Case startedFrom = std::exchange(startedFrom_, {});   // releases the cine run, which is large
    const core::TrackedRun run = core::makeTrackedRun(startedFrom.shown().frame, frames);
    if (!matchesStart(startedFrom, run)) {
        parts_.notifications.showNote(tr("The vessels were moved during tracking. Track them again."));
        return;
    }
    if (!parts_.document.push(std::make_unique<SetTrackedPoses>(parts_.document, SetTrackedPoses::Values{run},
                                                                [] { return tr("Track vessels through the run"); }))) {
        return;
    }
    const auto lost = std::ranges::count_if(frames, [](const auto& each) { return !each.tracked.isTrustworthy; });
    const auto count = static_cast<int>(frames.size());
    const QString followed =
        lost == 0 ? tr("Tracked through %1 frames; scroll through the frames or play them").arg(count)
                  : tr("Tracked through %1 frames; in %2 of them, the vessels are not sufficiently visible")
                        .arg(count)
                        .arg(lost);
    parts_.notifications.showNote(followed + periodWords(core::periodsOf(startedFrom, frames)));
}

/// Returns whether the tracked poses belong to the current vessels and cine run and start from the current pose.
bool TrackingController::matchesStart(const core::Case& started, const core::TrackedRun& run) const
{
    const core::Case& current = parts_.document.current();
    const core::View& view = current.shown();
    const core::View& before = started.shown();
    const core::TrackedRunFrame* shown = core::findFrame(run, view.frame);
    return current.vessels.tree == started.vessels.tree && view.angiogram == before.angiogram &&
           current.vessels.excludedBranchIds == started.vessels.excludedBranchIds &&
           view.traceOptions == before.traceOptions && view.target.centerline == before.target.centerline &&
           core::cameraOf(view) && core::cameraOf(before) &&
           core::cameraOf(view).value() == core::cameraOf(before).value() &&
           (!shown || shown->tracked.cameraFromPatient.matrix() == view.cameraFromPatient.matrix());
}

void TrackingController::updateFromDocument()
{
    const core::View& view = parts_.document.current().shown();
    const bool isRun = view.angiogram && view.angiogram->frameCount() > 1 && parts_.document.current().vessels.tree;
    parts_.actions[ui::Command::TrackVessels]->setEnabled(isRun);
    if (view.followed.frames != shownPoses_) {
        shownPoses_ = view.followed.frames;
        parts_.preview.end(PreviewSource::Frame);
        showMotion();
    }
    parts_.actions[ui::Command::ExportTrackedPoses]->setEnabled(!frames().empty());
}

/// Shows each frame with its own pose during playback; the document already holds the pose of the document's frame.
void TrackingController::showFrame(int frame)
{
    parts_.panel.motion().showCurrent(frame);
    if (frames().empty() || parts_.document.isLocked()) {
        return;
    }
    const core::View& view = parts_.document.current().shown();
    const core::TrackedRunFrame* followed = core::findFrame(view.followed, frame);
    if (frame == view.frame || !followed) {
        parts_.preview.end(PreviewSource::Frame);
    } else {
        parts_.preview.show(PreviewSource::Frame, followed->tracked.cameraFromPatient, ResidualColors::Hidden);
    }
}

void TrackingController::showMotion()
{
    const core::Case& current = parts_.document.current();
    const core::TrackedRun& run = current.shown().followed;
    std::vector<ui::FrameMotion> motion;
    const Eigen::Vector3d pivot =
        current.vessels.tree ? core::centroidInPatient(*current.vessels.tree) : Eigen::Vector3d::Zero();
    const core::TrackedRunFrame* const from = core::findFrame(run, run.startFrame);
    for (const core::TrackedRunFrame& each : core::framesOf(run)) {
        const core::PoseDifference moved =
            core::differenceBetween(from ? from->tracked.cameraFromPatient : current.shown().cameraFromPatient,
                                    each.tracked.cameraFromPatient, pivot);
        motion.push_back({each.frame, moved.inPlaneMm, moved.depthMm, moved.rotationDeg, each.tracked.isTrustworthy});
    }
    parts_.panel.showMotion(motion);
    parts_.panel.motion().showCurrent(parts_.sync.shownFrame());
}

void TrackingController::exportPoses()
{
    if (frames().empty()) {
        return;
    }
    parts_.exportController.askForFile(
        {tr("Export tracked poses"), tr("Tables (*.csv)"), QStringLiteral("poses.csv")},
        [frames = frames()](const QString& path) { return io::writePoseTable(frames, path.toStdString()); });
}

}   // namespace angiopose::app

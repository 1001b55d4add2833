#include "app/review/follow_controller.h"

#include "core/geometry/pose_difference.h"
#include "io/pose_table.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/bottom_strip.h"
#include "ui/panels/result_panel.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"

#include <algorithm>

namespace angiopose::app {
namespace {

bool isFollowedPose(const core::RigidTransform& a, const core::RigidTransform& b)
{
    return a.matrix() == b.matrix();
}

/// " · breath every 3.7 s, 8.2 mm to and fro", or nothing.
QString periodWords(const core::RunPeriods& periods)
{
    const auto words = [](const QString& sentence, const core::PeriodicMotion& motion) {
        return QStringLiteral(" · ") +
               sentence.arg(ui::numberText(motion.periodS, 1), ui::numberText(2.0 * motion.amplitudeMm, 1));
    };
    QString text;
    if (periods.breath) {
        text += words(FollowController::tr("breath every %1 s, %2 mm to and fro"), *periods.breath);
    }
    if (periods.heart) {
        text += words(FollowController::tr("heartbeat every %1 s, %2 mm to and fro"), *periods.heart);
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
                tr("Following the vessels through the run: %1 %").arg(ui::numberText(100.0 * fraction, 0)), fraction);
        }
    });
    connect(&job_, &FollowJob::finished, this, &FollowController::take);
    connect(&job_, &FollowJob::failed, this, [this](const core::Message& reason) {
        forget();   // it holds the case that it started from
        on_.strip.showIdle(tr("Ready"));
        on_.notices.showProblem(tr("The vessels cannot be followed"), ui::messageText(reason));
    });
    connect(&on_.document, &CaseDocument::changed, this, &FollowController::followDocument);
    connect(&on_.sync, &ViewSync::frameShown, this, &FollowController::showFrame);
    on_.review.setFramePoses([this](int frame) { return poseOf(frame); });
    on_.judgement.setFollowedPoses([this](int frame) { return poseOf(frame); });
    followDocument();
}

QString FollowController::whyNot() const
{
    const core::Case& current = on_.document.current();
    if (on_.document.isInTrial() || on_.document.isLocked()) {
        return tr("Something else is under way. Let it end first.");
    }
    return !current.vessels.tree || !current.shown().angiogram ? tr("Open vessels and an angiogram first.") : QString();
}

void FollowController::start()
{
    if (job_.isRunning()) {
        return;
    }
    if (const QString why = whyNot(); !why.isEmpty()) {
        on_.notices.showNote(why);
        return;
    }
    on_.review.stopMotion();
    forget();
    startedFrom_ = on_.document.current();
    on_.strip.showBusy(tr("Following the vessels through the run …"));
    job_.start(startedFrom_);
}

void FollowController::take(const std::vector<core::FollowedFrame>& frames)
{
    on_.strip.showIdle(tr("Ready"));
    frames_ = frames;
    if (!holds()) {
        forget();
        on_.notices.showNote(tr("The vessels were moved meanwhile: follow them again."));
        return;
    }
    on_.document.keepFollowed(core::bendsOf(frames_));
    showMotion();
    const auto lost = std::ranges::count_if(frames_, [](const auto& each) { return !each.tracked.isTrustworthy; });
    const auto count = static_cast<int>(frames_.size());
    const QString followed =
        lost == 0
            ? tr("Followed through %1 frames: scroll or play them").arg(count)
            : tr("Followed through %1 frames; %2 of them do not show the vessels well enough").arg(count).arg(lost);
    on_.notices.showNote(followed + periodWords(core::periodsOf(startedFrom_, frames_)));
}

std::optional<core::RigidTransform> FollowController::poseOf(int frame) const
{
    const auto found = std::ranges::find(frames_, frame, &core::FollowedFrame::frame);
    return found == frames_.end() ? std::nullopt : std::optional(found->tracked.cameraFromPatient);
}

/// Whether the poses still are of these vessels, in this run, from this pose on.
bool FollowController::holds() const
{
    const core::Case& current = on_.document.current();
    const auto pose = poseOf(current.shown().frame);
    return current.vessels.tree == startedFrom_.vessels.tree &&
           current.shown().angiogram == startedFrom_.shown().angiogram &&
           current.vessels.excludedBranchIds == startedFrom_.vessels.excludedBranchIds &&
           core::cameraOf(current.shown()) && core::cameraOf(startedFrom_.shown()) &&
           core::cameraOf(current.shown()).value() == core::cameraOf(startedFrom_.shown()).value() &&
           (!pose || isFollowedPose(*pose, current.shown().cameraFromPatient));
}

void FollowController::followDocument()
{
    const auto& angiogram = on_.document.current().shown().angiogram;
    const bool isRun = angiogram && angiogram->frameCount() > 1 && on_.document.current().vessels.tree;
    on_.actions[ui::Command::FollowFrames]->setEnabled(isRun);
    if (!frames_.empty() && !holds()) {
        forget();
    }
    on_.actions[ui::Command::ExportFollowed]->setEnabled(!frames_.empty());
}

/// While frames play, each is shown with its pose; the document's own frame has it already.
void FollowController::showFrame(int frame)
{
    on_.panel.motion().showCurrent(frame);
    if (frames_.empty() || on_.document.isLocked()) {
        return;
    }
    const auto pose = poseOf(frame);
    if (frame == on_.document.current().shown().frame || !pose) {
        on_.preview.end(PreviewOf::Frame);
    } else {
        on_.preview.show(PreviewOf::Frame, *pose, ResidualColors::Hidden);
    }
}

void FollowController::showMotion()
{
    const core::Case& current = on_.document.current();
    std::vector<ui::FrameMotion> motion;
    const Eigen::Vector3d pivot =
        current.vessels.tree ? core::centroidInPatient(*current.vessels.tree) : Eigen::Vector3d::Zero();
    for (const core::FollowedFrame& each : frames_) {
        const core::PoseDifference from =
            core::differenceBetween(startedFrom_.shown().cameraFromPatient, each.tracked.cameraFromPatient, pivot);
        motion.push_back({each.frame, from.inPlaneMm, from.depthMm, from.rotationDeg, each.tracked.isTrustworthy});
    }
    on_.panel.showMotion(motion);
    on_.panel.motion().showCurrent(on_.sync.shownFrame());
    on_.actions[ui::Command::ExportFollowed]->setEnabled(!frames_.empty());
}

void FollowController::forget()
{
    frames_.clear();
    on_.document.keepFollowed(nullptr);
    on_.preview.end(PreviewOf::Frame);
    startedFrom_ = {};   // a run is large
    showMotion();
}

void FollowController::exportPoses()
{
    if (frames_.empty()) {
        return;
    }
    on_.exporting.askFile(
        {tr("Export followed poses"), tr("Tables (*.csv)"), QStringLiteral("poses.csv")},
        [frames = frames_](const QString& path) { return io::writePoseTable(frames, path.toStdString()); });
}

}   // namespace angiopose::app
#include "app/editing/pose_controller.h"

#include "app/document/edit_case.h"
#include "core/case/case_views.h"

#include <algorithm>
#include <cmath>

namespace angiopose::app {
namespace {

constexpr qint64 poseBurstPauseMs = 900;   ///< a pause longer than this starts a new undo step
constexpr int fieldKind = 100;   ///< merge ID of typed edits, which merge with each other but not with nudges

}   // namespace

PoseController::PoseController(CaseDocument& document, QObject* parent) : QObject(parent), document_(document) {}

std::optional<PoseController::Frame> PoseController::frame() const
{
    const core::Case& current = document_.current();
    if (!current.vessels.tree) {
        return std::nullopt;
    }
    const auto start = core::initialPoseOf(current);
    const auto camera = core::cameraOf(current.shown());
    if (!start || !camera) {
        return std::nullopt;
    }
    return Frame{start.value(), camera.value(), *core::pivotInPatient(current.vessels)};
}

std::optional<core::PoseOffset> PoseController::currentOffset() const
{
    const auto context = frame();
    if (!context) {
        return std::nullopt;
    }
    const core::RigidTransform& pose = dragged_.value_or(document_.current().shown().cameraFromPatient);
    return core::offsetBetween(context->initialPose, pose, context->pivotInPatient, context->camera);
}

bool PoseController::differsFromInitialPose() const
{
    const auto offset = currentOffset();
    return offset && std::ranges::any_of(ui::poseAxes, [&offset](ui::PoseAxis axis) {
               return std::abs(ui::valueOf(*offset, axis)) > 1e-6;
           });
}

void PoseController::setLocks(const ui::PoseLocks& locks)
{
    core::RegistrationOptions options = document_.current().options;
    if (options.locks != locks) {
        options.locks = locks;
        document_.push(std::make_unique<ChangeOptions>(document_, ChangeOptions::Values{options},
                                                       [] { return tr("Change locks"); }));
    }
}

void PoseController::setOffset(const core::PoseOffset& fromStart)
{
    if (const auto context = frame()) {
        move(
            core::applyOffset(context->initialPose, fromStart, context->pivotInPatient, context->camera),
            [] { return tr("Move vessels"); }, mergeIdFor(fieldKind));
    }
}

void PoseController::nudge(const ui::Nudge& nudge)
{
    const auto context = frame();
    if (!context) {
        emit refused(
            tr("There is no pose to nudge yet. Open vessels and an angiogram and complete the geometry first."));
        return;
    }
    if (core::isLocked(locks(), nudge.axis)) {
        emit refused(tr("“%1” is locked.").arg(ui::labelOf(nudge.axis)));
        return;
    }
    // The change is relative to the current pose, so a degree of freedom means the same for every vessel orientation.
    core::PoseOffset change;
    ui::valueOf(change, nudge.axis) = nudge.amount;
    move(
        core::applyOffset(document_.current().shown().cameraFromPatient, change, context->pivotInPatient,
                          context->camera),
        [] { return tr("Move vessels"); }, mergeIdFor(static_cast<int>(nudge.axis)));
}

void PoseController::reset()
{
    if (frame()) {
        push(
            core::viewsAtInitialPose(document_.current()), [] { return tr("Reset to initial pose"); }, noMergeId);
    }
}

void PoseController::startDrag()
{
    if (document_.isLocked()) {
        emit refused(tr("A registration is running. Stop it first."));
        return;
    }
    if (frame()) {
        dragStart_ = document_.current().shown().cameraFromPatient;
    }
}

void PoseController::drag(const core::PoseOffset& sinceStart)
{
    const auto context = frame();
    if (!dragStart_ || !context) {
        return;
    }
    dragged_ =
        core::applyOffset(*dragStart_, ui::zeroLocked(sinceStart, locks()), context->pivotInPatient, context->camera);
    emit previewed(*dragged_);
}

void PoseController::finishDrag()
{
    const auto moved = std::exchange(dragged_, std::nullopt);
    dragStart_.reset();
    emit previewEnded();
    if (moved) {
        move(
            *moved, [] { return tr("Move vessels"); }, noMergeId);
    }
}

void PoseController::cancelDrag()
{
    dragged_.reset();
    dragStart_.reset();
    emit previewEnded();
}

void PoseController::move(const core::RigidTransform& pose, const ui::LocalizedText& name, int mergeId)
{
    push(core::viewsAfterMotion(document_.current(), pose), name, mergeId);
}

/// Pushes the new pose of the shown view, and those of the other views if all views move together.
void PoseController::push(std::vector<core::View> moved, const ui::LocalizedText& name, int mergeId)
{
    const core::Case& current = document_.current();
    const core::RigidTransform pose = moved[current.shownView].cameraFromPatient;
    if ((pose.matrix() - current.shown().cameraFromPatient.matrix()).cwiseAbs().maxCoeff() == 0.0) {
        return;
    }
    if (movesOtherViews()) {
        document_.push(std::make_unique<ChangeViews>(document_, ChangeViews::Values{std::move(moved)}, name, mergeId));
    } else {
        document_.push(std::make_unique<MovePose>(document_, MovePose::Values{pose, std::nullopt, {}}, name, mergeId));
    }
}

int PoseController::mergeIdFor(int kind)
{
    const bool shouldContinue = kind == mergeKind_ && sinceEdit_.isValid() && sinceEdit_.elapsed() < poseBurstPauseMs;
    if (!shouldContinue) {
        ++mergeId_;
        mergeKind_ = kind;
    }
    sinceEdit_.start();
    return mergeId_;
}

}   // namespace angiopose::app

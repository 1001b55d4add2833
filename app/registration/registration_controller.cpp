#include "app/registration/registration_controller.h"

#include "app/document/edit_case.h"
#include "app/words/snapshot_texts.h"
#include "core/registration/methods/method_info.h"
#include "core/support/utc_time.h"
#include "ui/words/message_text.h"
#include "ui/words/terms.h"

namespace angiopose::app {

RegistrationController::RegistrationController(CaseDocument& document, TargetProvider& target, QObject* parent)
    : QObject(parent), document_(document), target_(target)
{
    connect(&target_, &TargetProvider::changed, this, &RegistrationController::continueAfterTracing);
    connect(&job_, &RegistrationJob::progressed, this, &RegistrationController::progressed);
    connect(&job_, &RegistrationJob::finished, this, &RegistrationController::apply);
    connect(&job_, &RegistrationJob::failed, this, &RegistrationController::reportFailure);
}

QString RegistrationController::notReadyReason() const
{
    const core::Case& current = document_.current();
    if (document_.isInTrial()) {
        return tr("In a blind trial, align the vessels manually.");
    }
    if (!current.vessels.tree) {
        return tr("Open a vessel centerline first.");
    }
    if (!current.shown().angiogram) {
        return tr("Open an angiogram first.");
    }
    if (const auto camera = core::cameraOf(current.shown()); !camera) {
        return ui::messageText(camera.error().message);
    }
    if (const auto start = core::initialPoseOf(current); !start) {
        return ui::messageText(start.error().message);
    }
    return ui::messageText(core::findProblem(current.options));
}

void RegistrationController::start()
{
    if (isRunning() || document_.isInTrial()) {
        return;
    }
    if (const QString why = notReadyReason(); !why.isEmpty()) {
        emit failed(why);
        return;
    }
    phase_ = Phase::Tracing;
    stopRequested_ = false;
    document_.setLocked(true);
    emit runningChanged(true);
    emit tracingStarted();
    target_.setCase(document_.current());
    continueAfterTracing();
}

void RegistrationController::stop()
{
    if (phase_ == Phase::Tracing) {
        end();
    } else if (phase_ == Phase::Solving) {
        stopRequested_ = true;
        job_.requestStop();
    }
}

void RegistrationController::continueAfterTracing()
{
    if (phase_ != Phase::Tracing) {
        return;
    }
    if (const auto problem = target_.problem()) {
        end();
        emit failed(ui::messageText(*problem));
        return;
    }
    if (!target_.current()) {
        return;
    }
    phase_ = Phase::Solving;
    using Views =
        core::RegistrationPlan::Views;   // `Loaded` skips views whose image is missing, which the view strip marks
    job_.start(document_.current(), {.views = registersAllViews_ ? Views::Loaded : Views::Shown,
                                     .shownTarget = *target_.current(),
                                     .author = observerName().toStdString(),
                                     .time = core::utcNow()});
}

void RegistrationController::apply(const core::RegisteredCase& registered)
{
    end();
    std::vector<core::View> views = document_.current().views;   // includes snapshots saved during registration
    for (const std::size_t place : registered.viewIndices) {
        core::View& view = views[place];
        core::applyRegistration(view, registered.session.views[place]);
        view.snapshots = core::withSnapshot(std::move(view.snapshots), snapshotOfRun(*view.result, view.frame));
    }
    const bool areSeveral = registered.joint.has_value();
    document_.push(std::make_unique<ChangeViews>(
        document_, ChangeViews::Values{std::move(views)}, [areSeveral, method = registered.result().method] {
            return areSeveral ? tr("Register all views") : tr("Register (%1)").arg(ui::methodName(method));
        }));
    emit finished(registered.result());
}

void RegistrationController::reportFailure(const core::Message& reason)
{
    end();
    if (!stopRequested_) {   // if stopped before any pose was found, there is nothing to report
        emit failed(ui::messageText(reason));
    }
}

void RegistrationController::end()
{
    phase_ = Phase::Idle;
    document_.setLocked(false);
    emit runningChanged(false);
}

}   // namespace angiopose::app

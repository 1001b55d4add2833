#include "app/jobs/radiograph_job.h"

#include "app/jobs/future_result.h"
#include "app/jobs/guarded.h"
#include "app/jobs/radiograph_source.h"

#include <QtConcurrentRun>

#include <utility>

namespace angiopose::app {

RadiographJob::RadiographJob(QObject* parent) : QObject(parent)
{
    connect(&watcher_, &QFutureWatcherBase::finished, this, &RadiographJob::publish);
}

RadiographJob::~RadiographJob()
{
    waitFor(watcher_);
}

void RadiographJob::setInput(core::RegistrationInput input, core::RegistrationOptions options)
{
    cancel();
    source_ = std::make_shared<RadiographSource>(std::move(input), std::move(options));
}

void RadiographJob::clear()
{
    cancel();
    source_.reset();
}

void RadiographJob::cancel()
{
    waiting_.reset();
    cancelled_ = running_;
}

void RadiographJob::request(const core::RigidTransform& cameraFromPatient)
{
    if (running_) {
        waiting_ = cameraFromPatient;
    } else if (source_) {
        start(cameraFromPatient);
    }
}

void RadiographJob::start(const core::RigidTransform& cameraFromPatient)
{
    running_ = true;
    cancelled_ = false;
    watcher_.setFuture(QtConcurrent::run([source = source_, cameraFromPatient] {
        return guarded<core::ImageF>([&] { return source->from(cameraFromPatient); });
    }));
}

void RadiographJob::publish()
{
    running_ = false;
    const core::Result<core::ImageF> outcome = takeResult(watcher_);
    const bool wasCancelled = std::exchange(cancelled_, false);
    if (const auto next = std::exchange(waiting_, std::nullopt)) {
        start(*next);
    }
    if (wasCancelled) {
        return;
    }
    if (outcome) {
        emit made(outcome.value());
    } else {
        emit failed(outcome.error().message);
    }
}

}   // namespace angiopose::app
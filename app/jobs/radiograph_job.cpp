#include "app/jobs/radiograph_job.h"

#include "app/jobs/radiograph_source.h"

#include <utility>

namespace angiopose::app {

RadiographJob::RadiographJob(QObject* parent)
    : QObject(parent),
      job_({[this](const core::ImageF& picture) {
                startWaiting();
                emit made(picture);
            },
            [this](const core::Error& error) {
                startWaiting();
                emit failed(error.message);
            }})
{
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
    job_.drop();
}

void RadiographJob::request(const core::RigidTransform& cameraFromPatient)
{
    if (job_.isRunning()) {
        waiting_ = cameraFromPatient;
    } else if (source_) {
        start(cameraFromPatient);
    }
}

void RadiographJob::start(const core::RigidTransform& cameraFromPatient)
{
    job_.start([source = source_, cameraFromPatient](JobLink<double>&) { return source->from(cameraFromPatient); });
}

void RadiographJob::startWaiting()
{
    if (const auto next = std::exchange(waiting_, std::nullopt)) {
        start(*next);
    }
}

}   // namespace angiopose::app

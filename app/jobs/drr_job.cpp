#include "app/jobs/drr_job.h"

#include <utility>

namespace angiopose::app {

DrrSource::DrrSource(core::RegistrationInput input, core::RegistrationOptions options)
    : input_(std::move(input)), options_(std::move(options))
{
}

core::Result<core::ImageF> DrrSource::from(const core::RigidTransform& cameraFromPatient)
{
    if (!drr_) {
        auto problem = core::makeProblem(input_, options_);
        if (!problem) {
            return problem.error();
        }
        problem_ = std::make_unique<core::RegistrationProblem>(std::move(problem).value());
        drr_.emplace(*problem_);
    }
    return drr_->from(cameraFromPatient);
}

DrrJob::DrrJob(QObject* parent)
    : QObject(parent),
      job_({[this](const core::ImageF& picture) {
                startPending();
                emit rendered(picture);
            },
            [this](const core::Error& error) {
                startPending();
                emit failed(error.message);
            }})
{
}

void DrrJob::setInput(core::RegistrationInput input, core::RegistrationOptions options)
{
    cancel();
    source_ = std::make_shared<DrrSource>(std::move(input), std::move(options));
}

void DrrJob::clear()
{
    cancel();
    source_.reset();
}

void DrrJob::cancel()
{
    pending_.reset();
    job_.drop();
}

void DrrJob::request(const core::RigidTransform& cameraFromPatient)
{
    if (job_.isRunning()) {
        pending_ = cameraFromPatient;
    } else if (source_) {
        start(cameraFromPatient);
    }
}

void DrrJob::start(const core::RigidTransform& cameraFromPatient)
{
    job_.start([source = source_, cameraFromPatient](JobLink<double>&) { return source->from(cameraFromPatient); });
}

void DrrJob::startPending()
{
    if (const auto next = std::exchange(pending_, std::nullopt)) {
        start(*next);
    }
}

}   // namespace angiopose::app

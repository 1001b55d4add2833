#include "app/jobs/registration_job.h"

#include "app/jobs/future_result.h"
#include "app/jobs/guarded.h"
#include "app/jobs/publish_outcome.h"

#include <QtConcurrentRun>

#include <chrono>
#include <utility>

namespace angiopose::app {
namespace {

/// Lets through what the eye can follow; a fast solver would flood the event queue.
class Throttle {
public:
    bool passes()
    {
        const auto now = Clock::now();
        if (now - last_ < std::chrono::milliseconds(33)) {
            return false;
        }
        last_ = now;
        return true;
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_{};
};

}   // namespace

RegistrationJob::RegistrationJob(QObject* parent) : QObject(parent)
{
    connect(&watcher_, &QFutureWatcherBase::finished, this, &RegistrationJob::publish);
}

RegistrationJob::~RegistrationJob()
{
    requestStop();
    waitFor(watcher_);
}

void RegistrationJob::start(core::RegistrationInput input, core::RegistrationOptions options)
{
    Q_ASSERT(!isRunning());
    stopRequested_ = false;
    publishPending_ = true;
    watcher_.setFuture(QtConcurrent::run([this, input = std::move(input), options = std::move(options)]() -> Outcome {
        Throttle throttle;
        const auto observe = [this, &throttle](const core::IterationReport& report) {
            if (throttle.passes()) {
                QMetaObject::invokeMethod(
                    this, [this, report] { emit advanced(report); }, Qt::QueuedConnection);
            }
            return stopRequested_ ? core::Verdict::Stop : core::Verdict::Continue;
        };
        return guarded<core::RegistrationResult>([&] { return core::registerVessels(input, options, observe); });
    }));
}

void RegistrationJob::publish()
{
    publishPending_ = false;
    publishOutcome(*this, takeResult(watcher_));
}

}   // namespace angiopose::app
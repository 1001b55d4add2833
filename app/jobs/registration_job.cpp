#include "app/jobs/registration_job.h"

#include "app/jobs/future_result.h"
#include "app/jobs/guarded.h"
#include "app/jobs/publish_outcome.h"

#include <QtConcurrentRun>

#include <chrono>
#include <optional>
#include <utility>

namespace angiopose::app {
namespace {

/// Lets through what the eye can follow, and the first of each view; a fast solver would flood the event queue.
class Throttle {
public:
    bool passes(std::size_t view)
    {
        const auto now = Clock::now();
        if (view == view_ && now - last_ < std::chrono::milliseconds(33)) {
            return false;
        }
        last_ = now;
        view_ = view;
        return true;
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_{};
    std::optional<std::size_t> view_;
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

void RegistrationJob::start(core::Case theCase, core::RegistrationPlan plan)
{
    Q_ASSERT(!isRunning());
    stopRequested_ = false;
    publishPending_ = true;
    watcher_.setFuture(
        QtConcurrent::run([this, theCase = std::move(theCase), plan = std::move(plan)]() mutable -> Outcome {
            return guarded<core::RegisteredCase>([&] { return run(std::move(theCase), std::move(plan)); });
        }));
}

RegistrationJob::Outcome RegistrationJob::run(core::Case theCase, core::RegistrationPlan plan)
{
    Throttle throttle;
    const std::size_t shown = theCase.shownView;
    return core::registerCase(std::move(theCase), std::move(plan),
                              [this, &throttle, shown](const core::WorkReport& report) {
                                  if (report.iteration && throttle.passes(report.view)) {
                                      RunReport told{*report.iteration, report.view == shown};
                                      told.iteration.progress = report.fraction;
                                      QMetaObject::invokeMethod(
                                          this, [this, told] { emit advanced(told); }, Qt::QueuedConnection);
                                  }
                                  return stopRequested_ ? core::Verdict::Stop : core::Verdict::Continue;
                              });
}

void RegistrationJob::publish()
{
    publishPending_ = false;
    publishOutcome(*this, takeResult(watcher_));
}

}   // namespace angiopose::app

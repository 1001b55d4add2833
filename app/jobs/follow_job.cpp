#include "app/jobs/follow_job.h"

#include "app/jobs/future_result.h"
#include "app/jobs/guarded.h"
#include "app/jobs/publish_outcome.h"

#include <QtConcurrentRun>

#include <utility>

namespace angiopose::app {

FollowJob::FollowJob(QObject* parent) : QObject(parent)
{
    connect(&watcher_, &QFutureWatcherBase::finished, this, &FollowJob::publish);
}

FollowJob::~FollowJob()
{
    requestStop();
    waitFor(watcher_);
}

void FollowJob::start(core::Case theCase)
{
    Q_ASSERT(!running_);
    running_ = true;
    stopRequested_ = false;
    watcher_.setFuture(QtConcurrent::run([this, followed = std::move(theCase)]() -> Outcome {
        return guarded<std::vector<core::FollowedFrame>>([&] {
            return core::followFrames(followed, [this](const core::WorkReport& report) {
                QMetaObject::invokeMethod(
                    this, [this, fraction = report.fraction] { emit advanced(fraction); }, Qt::QueuedConnection);
                return stopRequested_ ? core::Verdict::Stop : core::Verdict::Continue;
            });
        });
    }));
}

void FollowJob::publish()
{
    running_ = false;
    publishOutcome(*this, takeResult(watcher_));
}

}   // namespace angiopose::app
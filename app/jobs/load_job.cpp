#include "app/jobs/load_job.h"

#include "app/jobs/freed_elsewhere.h"
#include "app/jobs/future_result.h"
#include "app/jobs/guarded.h"
#include "app/jobs/publish_outcome.h"

#include <QtConcurrentRun>

namespace angiopose::app {
namespace {

constexpr int loadPollMs = 60;

}   // namespace

LoadJob::LoadJob(QObject* parent) : QObject(parent)
{
    connect(&watcher_, &QFutureWatcherBase::finished, this, &LoadJob::publish);
    poll_.setInterval(loadPollMs);
    connect(&poll_, &QTimer::timeout, this, [this] { emit advanced(shared_->fraction); });
}

LoadJob::~LoadJob()
{
    abandon();
}

void LoadJob::start(const QStringList& paths, const OpenHints& hints)
{
    Q_ASSERT(!isRunning());
    running_ = true;
    paths_ = paths;
    shared_ = std::make_shared<Shared>();
    poll_.start();
    watcher_.setFuture(QtConcurrent::run([paths, hints, shared = shared_] {
        const io::ReadObserver observe = [&shared](double fraction) {
            shared->fraction = fraction;
            return shared->isStopWished ? core::Verdict::Stop : core::Verdict::Continue;
        };
        return guarded<LoadedInputs>([&]() -> Outcome {
            auto inputs = readInputs(paths, hints, observe);
            if (!inputs) {
                return inputs;
            }
            return freedElsewhere(std::move(inputs).value());
        });
    }));
}

void LoadJob::abandon()
{
    // The worker stops at its next look; its outcome is dropped by watching nothing.
    if (shared_) {
        shared_->isStopWished = true;
    }
    poll_.stop();
    running_ = false;
    watcher_.setFuture({});
}

void LoadJob::publish()
{
    if (!running_ || watcher_.future().resultCount() == 0) {
        return;
    }
    running_ = false;
    poll_.stop();
    publishOutcome(*this, takeResult(watcher_));
}

}   // namespace angiopose::app
#pragma once

#include "app/jobs/future_result.h"
#include "app/jobs/guarded.h"
#include "core/support/observer_decision.h"

#include <QFutureWatcher>
#include <QObject>
#include <QTimer>
#include <QtConcurrentRun>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace angiopose::app {

/// State that a worker shares with the job that waits for it; exists as long as either of them.
template <class Report>
class JobLink {
public:
    /// Reports progress. The worker may call it at any rate, since only the newest report is delivered. Returns Stop
    /// after a stop request.
    core::ObserverDecision tell(Report report)
    {
        const std::lock_guard lock(mutex_);
        report_ = std::move(report);
        return decision();
    }
    core::ObserverDecision decision() const
    {
        return isStopRequested_ ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
    }

    void requestStop() { isStopRequested_ = true; }
    std::optional<Report> takeReport()
    {
        const std::lock_guard lock(mutex_);
        return std::exchange(report_, std::nullopt);
    }

private:
    std::atomic<bool> isStopRequested_{false};
    std::mutex mutex_;
    std::optional<Report> report_;
};

/// Runs one task at a time off the GUI thread. The task works on a snapshot; its reports (at most 30 per second) and
/// its outcome are delivered on the thread that created the job. The destructor requests a stop and returns without
/// waiting.
template <class Value, class Report = double>
class Job {
public:
    using Link = JobLink<Report>;
    using Outcome = core::Result<Value>;
    using Work = std::function<Outcome(Link&)>;   ///< holds copies of all data; exceptions become errors

    struct Callbacks {
        std::function<void(const Value&)> finished;
        std::function<void(const core::Error&)> failed;   ///< called if the work failed or stopped without a result
        std::function<void(const Report&)> progressed = {};
    };

    explicit Job(Callbacks callbacks) : callbacks_(std::move(callbacks))
    {
        poll_.setInterval(33);   // 33 ms, i.e. about 30 updates per second
        QObject::connect(&poll_, &QTimer::timeout, &poll_, [this] { deliverReport(); });
    }
    /// Creates a job that ignores failures, for results that are optional.
    explicit Job(std::function<void(const Value&)> finished)
        : Job(Callbacks{std::move(finished), [](const core::Error&) {}})
    {
    }
    ~Job() { drop(); }
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;

    void start(Work work)   ///< abandons a task in progress
    {
        drop();
        link_ = std::make_shared<Link>();
        watcher_ = std::make_unique<QFutureWatcher<Outcome>>();
        QObject::connect(watcher_.get(), &QFutureWatcherBase::finished, &poll_, [this] { publish(); });
        poll_.start();
        watcher_->setFuture(QtConcurrent::run([link = link_, work = std::move(work)]() -> Outcome {
            return guarded<Value>([&] { return work(*link); });
        }));
    }

    void requestStop()   ///< returns at once; the outcome is still delivered
    {
        if (link_) {
            link_->requestStop();
        }
    }

    void drop()   ///< stops the task without delivering an outcome
    {
        requestStop();
        link_.reset();
        watcher_.reset();
        poll_.stop();
    }

    bool isRunning() const { return link_ != nullptr; }

private:
    void deliverReport()
    {
        if (auto report = link_->takeReport(); report && callbacks_.progressed) {
            callbacks_.progressed(*report);
        }
    }

    void publish()
    {
        const auto link = link_;
        deliverReport();
        if (link != link_) {
            return;   // a receiver of the report has dropped the job
        }
        const Outcome outcome = takeResult(*watcher_);
        link_.reset();
        poll_.stop();
        watcher_.release()->deleteLater();   // deleted later, since its signal is still being delivered
        if (outcome) {
            callbacks_.finished(outcome.value());
        } else {
            callbacks_.failed(outcome.error());
        }
    }

    Callbacks callbacks_;
    QTimer poll_;
    std::shared_ptr<Link> link_;   ///< link to the task in progress; null if there is none
    std::unique_ptr<QFutureWatcher<Outcome>> watcher_;
};

/// Returns callbacks that emit the signals of `owner`: finished(found), failed(message) and advanced(report), the last
/// only if `owner` has this signal.
template <class Value, class Report = double, class Owner>
typename Job<Value, Report>::Callbacks emitAsSignals(Owner& owner)
{
    typename Job<Value, Report>::Callbacks callbacks{
        [&owner](const Value& found) { emit owner.finished(found); },
        [&owner](const core::Error& error) { emit owner.failed(error.message); }};
    if constexpr (requires(const Report& report) { owner.progressed(report); }) {
        callbacks.progressed = [&owner](const Report& report) { emit owner.progressed(report); };
    }
    return callbacks;
}

}   // namespace angiopose::app

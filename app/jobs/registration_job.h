#pragma once

#include "core/support/result.h"
#include "core/workflow/register_case.h"

#include <QFutureWatcher>
#include <QObject>

#include <atomic>

namespace angiopose::app {

/// How far a running registration is, for the eye.
struct RunReport {
    core::IterationReport iteration;   ///< of the solver; its progress is that of the whole run
    bool isOfShownView = true;   ///< whose pose it is
};

/// Registers the open case off the GUI thread: core::registerCase. Every signal arrives on the job's own thread.
class RegistrationJob : public QObject {
    Q_OBJECT
public:
    explicit RegistrationJob(QObject* parent = nullptr);
    ~RegistrationJob() override;   ///< stops and waits, for one solver iteration or one frame's tracing at most

    void start(core::Case theCase, core::RegistrationPlan plan);
    void requestStop() { stopRequested_ = true; }   ///< returns at once; `finished` or `failed` follows
    bool isRunning() const { return watcher_.isRunning() || publishPending_; }

signals:
    void advanced(const app::RunReport& report);   ///< at most thirty times a second
    void finished(const core::RegisteredCase& registered);   ///< after a stop: with the best poses so far
    void failed(const core::Message& reason);

private:
    using Outcome = core::Result<core::RegisteredCase>;
    Outcome run(core::Case theCase, core::RegistrationPlan plan);
    void publish();

    std::atomic<bool> stopRequested_{false};
    QFutureWatcher<Outcome> watcher_;
    bool publishPending_ = false;
};

}   // namespace angiopose::app

#pragma once

#include "core/registration/registration.h"
#include "core/support/result.h"

#include <QFutureWatcher>
#include <QObject>

#include <atomic>

namespace angiopose::app {

/// Runs one registration off the GUI thread. Every signal arrives on the job's own thread.
class RegistrationJob : public QObject {
    Q_OBJECT
public:
    explicit RegistrationJob(QObject* parent = nullptr);
    ~RegistrationJob() override;   ///< stops and waits, for one solver iteration at most

    void start(core::RegistrationInput input, core::RegistrationOptions options);
    void requestStop() { stopRequested_ = true; }   ///< returns at once; `finished` follows
    bool isRunning() const { return watcher_.isRunning() || publishPending_; }

signals:
    void advanced(const core::IterationReport& report);   ///< at most thirty times a second
    void finished(const core::RegistrationResult& result);   ///< after a stop: best pose so far
    void failed(const core::Message& reason);

private:
    using Outcome = core::Result<core::RegistrationResult>;
    void publish();

    std::atomic<bool> stopRequested_{false};
    QFutureWatcher<Outcome> watcher_;
    bool publishPending_ = false;
};

}   // namespace angiopose::app
#pragma once

#include "core/registration/registration.h"
#include "core/support/result.h"

#include <QFutureWatcher>
#include <QObject>

#include <atomic>
#include <string>
#include <vector>

namespace angiopose::app {

/// Runs several methods one after the other off the GUI thread, each from the same input with its default or given
/// options. Every signal arrives on the job's own thread.
class MethodSeriesJob : public QObject {
    Q_OBJECT
public:
    explicit MethodSeriesJob(QObject* parent = nullptr);
    ~MethodSeriesJob() override;   ///< stops and waits, for one solver iteration at most

    void start(core::RegistrationInput input, core::RegistrationOptions options, std::vector<std::string> methodIds);
    void requestStop() { stopRequested_ = true; }   ///< returns at once; `ended` follows
    bool isRunning() const { return running_; }

signals:
    void advanced(const QString& methodId, double progress);   ///< over all methods, 0…1
    void solved(const core::RegistrationResult& result);   ///< once per method that reached its end
    void failed(const QString& methodId, const core::Message& reason);   ///< the next method follows
    void ended(bool wasStopped);

private:
    void solve(const core::RegistrationInput& input, core::RegistrationOptions options,
               const std::vector<std::string>& methodIds);
    void solveOne(const core::RegistrationInput& input, const core::RegistrationOptions& options, double done,
                  double share);

    std::atomic<bool> stopRequested_{false};
    QFutureWatcher<void> watcher_;
    bool running_ = false;
};

}   // namespace angiopose::app
#pragma once

#include "core/support/result.h"
#include "core/workflow/follow_frames.h"

#include <QFutureWatcher>
#include <QObject>

#include <atomic>
#include <vector>

namespace angiopose::app {

/// Follows the vessels through the frames of a run off the GUI thread. Every signal arrives on the job's own thread.
class FollowJob : public QObject {
    Q_OBJECT
public:
    explicit FollowJob(QObject* parent = nullptr);
    ~FollowJob() override;   ///< stops and waits, for one frame at most

    void start(core::Case theCase);
    void requestStop() { stopRequested_ = true; }   ///< returns at once; `finished` follows
    bool isRunning() const { return running_; }

signals:
    void advanced(double fraction);
    void finished(const std::vector<core::FollowedFrame>& frames);   ///< after a stop: those it came to
    void failed(const core::Message& reason);

private:
    using Outcome = core::Result<std::vector<core::FollowedFrame>>;
    void publish();

    std::atomic<bool> stopRequested_{false};
    QFutureWatcher<Outcome> watcher_;
    bool running_ = false;
};

}   // namespace angiopose::app
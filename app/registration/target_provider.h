#pragma once

#include "app/jobs/trace_job.h"
#include "core/case/case.h"

#include <QObject>

#include <deque>
#include <memory>
#include <optional>

namespace angiopose::app {

/// Provides the traced vessels of the case's current frame: the 2-D centerline stored in the case, or a trace computed
/// on a worker thread and cached by frame and options. Processes only the newest request.
class TargetProvider : public QObject {
    Q_OBJECT
public:
    explicit TargetProvider(QObject* parent = nullptr);

    void setCase(const core::Case& session);
    const SharedCenterline& current() const { return current_; }   ///< null until the target is ready
    const SharedTrace& trace() const { return trace_; }   ///< null if the target is stored in the case or not ready
    const std::optional<core::Message>& problem() const { return problem_; }   ///< reason why there is no target
    bool isTracing() const { return job_.isRunning(); }

signals:
    void changed();   ///< emitted when `current`, `problem` or `isTracing` may have changed

private:
    struct CachedTrace {
        std::weak_ptr<const core::Angiogram> run;   ///< weak, because only the case and its undo history own the run
        int frame = 0;
        core::TraceOptions options;
        SharedTrace trace;
    };

    void startRequested();
    SharedTrace findCached(const TraceRequest& request);
    void addToCache(const TraceRequest& traceRequest, const SharedTrace& traced);
    void setTarget(const SharedTrace& trace, const std::optional<core::Message>& problem);
    void setStoredTarget(const SharedCenterline& given);
    void setTarget(const SharedCenterline& target, const SharedTrace& trace,
                   const std::optional<core::Message>& problem);

    TraceJob job_;
    std::optional<TraceRequest> pendingRequest_;
    std::optional<TraceRequest> activeRequest_;   ///< request being processed
    std::deque<CachedTrace> cache_;   ///< cached traces, newest last
    SharedCenterline current_;
    SharedTrace trace_;
    std::optional<core::Message> problem_;
};

}   // namespace angiopose::app

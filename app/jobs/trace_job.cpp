#include "app/jobs/trace_job.h"

#include "app/jobs/freed_elsewhere.h"
#include "app/jobs/future_result.h"
#include "app/jobs/guarded.h"
#include "app/jobs/publish_outcome.h"

#include <QtConcurrentRun>

#include <utility>

namespace angiopose::app {
namespace {

core::Result<SharedTrace> trace(const TraceRequest& request)
{
    auto traced = core::traceFrame(*request.angiogram, request.frame, request.options);
    if (!traced) {
        return traced.error();
    }
    core::AngiogramTrace found = std::move(traced).value();
    return freedElsewhere(SharedTrace(std::make_shared<TracedFrame>(
        TracedFrame{std::move(found.centerline), std::move(found.suspectCurves), std::move(found.fieldMask)})));
}

}   // namespace

TraceJob::TraceJob(QObject* parent) : QObject(parent)
{
    connect(&watcher_, &QFutureWatcherBase::finished, this, &TraceJob::publish);
}

void TraceJob::start(TraceRequest request)
{
    Q_ASSERT(!isRunning() && request.angiogram && request.frame >= 0 &&
             request.frame < request.angiogram->frameCount());
    running_ = true;
    watcher_.setFuture(QtConcurrent::run(
        [snapshot = std::move(request)] { return guarded<SharedTrace>([&snapshot] { return trace(snapshot); }); }));
}

void TraceJob::publish()
{
    running_ = false;
    publishOutcome(*this, takeResult(watcher_));
}

}   // namespace angiopose::app
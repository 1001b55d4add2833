#include "app/jobs/trace_job.h"

#include "app/jobs/free_on_worker.h"

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
    return freeOnWorker(SharedTrace(
        std::make_shared<TracedFrame>(TracedFrame{std::move(found.centerline), std::move(found.suspectCurves),
                                                  std::move(found.warnings), std::move(found.fieldMask)})));
}

}   // namespace

TraceJob::TraceJob(QObject* parent) : QObject(parent), job_(emitAsSignals<SharedTrace>(*this)) {}

void TraceJob::start(TraceRequest request)
{
    Q_ASSERT(!isRunning() && request.angiogram && request.frame >= 0 &&
             request.frame < request.angiogram->frameCount());
    job_.start([request = std::move(request)](JobLink<double>&) { return trace(request); });
}

}   // namespace angiopose::app

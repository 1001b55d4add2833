#include "app/jobs/tracking_job.h"

#include <utility>

namespace angiopose::app {

TrackingJob::TrackingJob(QObject* parent)
    : QObject(parent), job_(emitAsSignals<std::vector<core::TrackedRunFrame>>(*this))
{
}

void TrackingJob::start(core::Case session)
{
    job_.start([session = std::move(session)](JobLink<double>& link) {
        return core::trackFrames(session,
                                 [&link](const core::WorkReport& report) { return link.tell(report.fraction); });
    });
}

}   // namespace angiopose::app

#include "app/jobs/follow_job.h"

#include <utility>

namespace angiopose::app {

FollowJob::FollowJob(QObject* parent) : QObject(parent), job_(signalsOf<std::vector<core::FollowedFrame>>(*this)) {}

void FollowJob::start(core::Case theCase)
{
    job_.start([theCase = std::move(theCase)](JobLink<double>& link) {
        return core::followFrames(theCase,
                                  [&link](const core::WorkReport& report) { return link.tell(report.fraction); });
    });
}

}   // namespace angiopose::app

#include "app/jobs/follow_job.h"

#include <utility>

namespace angiopose::app {

FollowJob::FollowJob(QObject* parent) : QObject(parent), job_(signalsOf<std::vector<core::FollowedFrame>>(*this)) {}

void FollowJob::start(core::Case session)
{
    job_.start([session = std::move(session)](JobLink<double>& link) {
        return core::followFrames(session,
                                  [&link](const core::WorkReport& report) { return link.tell(report.fraction); });
    });
}

}   // namespace angiopose::app

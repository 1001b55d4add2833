#include "app/jobs/registration_job.h"

#include <utility>

namespace angiopose::app {

RegistrationJob::RegistrationJob(QObject* parent)
    : QObject(parent), job_(emitAsSignals<core::RegisteredCase, RunReport>(*this))
{
}

void RegistrationJob::start(core::Case session, core::RegistrationPlan plan)
{
    job_.start([session = std::move(session), plan = std::move(plan)](JobLink<RunReport>& link) {
        return core::registerCase(session, plan, [&link, shown = session.shownView](const core::WorkReport& report) {
            if (!report.iteration) {
                return link.decision();
            }
            RunReport reported{*report.iteration, report.view == shown};
            reported.iteration.progress = report.fraction;
            return link.tell(std::move(reported));
        });
    });
}

}   // namespace angiopose::app

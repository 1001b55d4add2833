#include "app/jobs/registration_job.h"

#include <utility>

namespace angiopose::app {

RegistrationJob::RegistrationJob(QObject* parent)
    : QObject(parent), job_(signalsOf<core::RegisteredCase, RunReport>(*this))
{
}

void RegistrationJob::start(core::Case theCase, core::RegistrationPlan plan)
{
    job_.start([theCase = std::move(theCase), plan = std::move(plan)](JobLink<RunReport>& link) {
        return core::registerCase(theCase, plan, [&link, shown = theCase.shownView](const core::WorkReport& report) {
            if (!report.iteration) {
                return link.verdict();
            }
            RunReport told{*report.iteration, report.view == shown};
            told.iteration.progress = report.fraction;
            return link.tell(std::move(told));
        });
    });
}

}   // namespace angiopose::app

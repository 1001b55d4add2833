#include "app/jobs/load_job.h"

#include "app/jobs/freed_elsewhere.h"

namespace angiopose::app {

LoadJob::LoadJob(QObject* parent) : QObject(parent), job_(signalsOf<LoadedInputs>(*this)) {}

void LoadJob::start(const QStringList& paths, const OpenHints& hints)
{
    Q_ASSERT(!isRunning());
    paths_ = paths;
    job_.start([paths, hints](JobLink<double>& link) -> core::Result<LoadedInputs> {
        auto inputs = readInputs(paths, hints, [&link](double fraction) { return link.tell(fraction); });
        if (!inputs) {
            return inputs;
        }
        return freedElsewhere(std::move(inputs).value());
    });
}

}   // namespace angiopose::app

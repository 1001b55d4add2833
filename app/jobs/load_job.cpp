#include "app/jobs/load_job.h"

#include "app/jobs/free_on_worker.h"

namespace angiopose::app {

LoadJob::LoadJob(QObject* parent) : QObject(parent), job_(emitAsSignals<io::LoadedInputs>(*this)) {}

void LoadJob::start(const QStringList& paths, const io::OpenHints& hints)
{
    Q_ASSERT(!isRunning());
    paths_ = paths;
    std::vector<std::string> files;
    for (const QString& path : paths) {
        files.push_back(path.toStdString());
    }
    job_.start([files = std::move(files), hints](JobLink<double>& link) -> core::Result<io::LoadedInputs> {
        auto inputs = io::readInputs(files, hints, [&link](double fraction) { return link.tell(fraction); });
        if (!inputs) {
            return inputs;
        }
        return freeOnWorker(std::move(inputs).value());
    });
}

}   // namespace angiopose::app

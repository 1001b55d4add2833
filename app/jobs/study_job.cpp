#include "app/jobs/study_job.h"

#include "app/jobs/free_on_worker.h"

namespace angiopose::app {

StudyJob::StudyJob(QObject* parent) : QObject(parent), job_(emitAsSignals<SharedStudies, io::StudyProgress>(*this)) {}

void StudyJob::start(const QStringList& folders, io::StudyScope scope)
{
    std::vector<std::string> paths;
    for (const QString& place : folders) {
        paths.push_back(place.toStdString());
    }
    job_.start([paths, scope](JobLink<io::StudyProgress>& link) -> core::Result<SharedStudies> {
        const io::StudyObserver observe = [&link](const io::StudyProgress& progress) {
            return link.tell({progress.read, progress.found, freeOnWorker(progress.tree)});
        };
        auto tree =
            paths.size() == 1 ? io::readStudies(paths.front(), scope, observe) : io::readSeriesFolders(paths, observe);
        if (!tree) {
            return tree.error();
        }
        return freeOnWorker(SharedStudies(std::make_shared<const io::StudyTree>(std::move(tree).value())));
    });
}

}   // namespace angiopose::app

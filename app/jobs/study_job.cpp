#include "app/jobs/study_job.h"

#include "app/jobs/freed_elsewhere.h"

namespace angiopose::app {

StudyJob::StudyJob(QObject* parent) : QObject(parent), job_(signalsOf<SharedStudies, io::StudyProgress>(*this)) {}

void StudyJob::start(const QString& place, io::StudyReach reach)
{
    job_.start([place = place.toStdString(), reach](JobLink<io::StudyProgress>& link) -> core::Result<SharedStudies> {
        auto tree = io::readStudies(place, reach, [&link](const io::StudyProgress& progress) {
            return link.tell({progress.read, progress.found, freedElsewhere(progress.tree)});
        });
        if (!tree) {
            return tree.error();
        }
        return freedElsewhere(SharedStudies(std::make_shared<const io::StudyTree>(std::move(tree).value())));
    });
}

}   // namespace angiopose::app

#pragma once

#include "app/jobs/job.h"
#include "io/study/read_studies.h"

#include <QObject>
#include <QStringList>

namespace angiopose::app {

using SharedStudies = std::shared_ptr<const io::StudyTree>;

/// Looks through a folder, a disc or a DICOMDIR off the GUI thread. Stop is no failure: what was found comes.
class StudyJob : public QObject {
    Q_OBJECT
public:
    explicit StudyJob(QObject* parent = nullptr);

    /// Several are folders of series, all files of which are read.
    void start(const QStringList& places, io::StudyReach reach);
    void requestStop() { job_.requestStop(); }
    void abandon() { job_.drop(); }   ///< nothing comes any more
    bool isRunning() const { return job_.isRunning(); }

signals:
    void advanced(const io::StudyProgress& progress);
    void finished(const SharedStudies& tree);
    void failed(const core::Message& reason);

private:
    Job<SharedStudies, io::StudyProgress> job_;
};

}   // namespace angiopose::app

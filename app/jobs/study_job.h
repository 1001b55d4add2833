#pragma once

#include "app/jobs/job.h"
#include "io/study/read_studies.h"

#include <QObject>
#include <QStringList>

namespace angiopose::app {

using SharedStudies = std::shared_ptr<const io::StudyTree>;

/// Searches a folder, a disc or a DICOMDIR for studies off the GUI thread. A stop request is not a failure: the studies
/// found so far are delivered.
class StudyJob : public QObject {
    Q_OBJECT
public:
    explicit StudyJob(QObject* parent = nullptr);

    /// If there are several places, they must be folders of series, of which all files are read.
    void start(const QStringList& folders, io::StudyScope scope);
    void requestStop() { job_.requestStop(); }
    void abandon() { job_.drop(); }   ///< abandons the search without further signals
    bool isRunning() const { return job_.isRunning(); }

signals:
    void progressed(const io::StudyProgress& progress);
    void finished(const SharedStudies& tree);
    void failed(const core::Message& reason);

private:
    Job<SharedStudies, io::StudyProgress> job_;
};

}   // namespace angiopose::app

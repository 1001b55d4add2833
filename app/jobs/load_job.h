#pragma once

#include "app/jobs/job.h"
#include "io/opening/read_inputs.h"

#include <QObject>
#include <QStringList>

namespace angiopose::app {

/// Reads files off the GUI thread. When the job is abandoned or destroyed, it stops reading and discards what was read.
class LoadJob : public QObject {
    Q_OBJECT
public:
    explicit LoadJob(QObject* parent = nullptr);

    void start(const QStringList& paths, const io::OpenHints& hints = {});
    void abandon() { job_.drop(); }
    bool isRunning() const { return job_.isRunning(); }
    const QStringList& paths() const { return paths_; }

signals:
    void progressed(double fraction);
    void finished(const io::LoadedInputs& inputs);
    void failed(const core::Message& reason);

private:
    QStringList paths_;
    Job<io::LoadedInputs> job_;
};

}   // namespace angiopose::app

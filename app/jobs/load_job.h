#pragma once

#include "app/jobs/read_inputs.h"
#include "core/support/result.h"

#include <QFutureWatcher>
#include <QObject>
#include <QStringList>
#include <QTimer>

#include <atomic>
#include <memory>

namespace angiopose::app {

/// Reads files off the GUI thread. A job that is abandoned or destroyed stops its reading and drops what was read.
class LoadJob : public QObject {
    Q_OBJECT
public:
    explicit LoadJob(QObject* parent = nullptr);

    ~LoadJob() override;

    void start(const QStringList& paths, const OpenHints& hints = {});
    void abandon();
    bool isRunning() const { return running_; }
    const QStringList& paths() const { return paths_; }

signals:
    void advanced(double fraction);
    void finished(const app::LoadedInputs& inputs);
    void failed(const core::Message& reason);

private:
    using Outcome = core::Result<LoadedInputs>;
    /// What job and worker share: it outlives the job when that is dropped first.
    struct Shared {
        std::atomic<bool> isStopWished{false};
        std::atomic<double> fraction{0.0};
    };
    void publish();

    QStringList paths_;
    std::shared_ptr<Shared> shared_;
    QTimer poll_;   ///< looks at the worker's progress
    QFutureWatcher<Outcome> watcher_;
    bool running_ = false;
};

}   // namespace angiopose::app
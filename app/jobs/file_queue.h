#pragma once

#include "core/support/result.h"

#include <QFutureWatcher>
#include <QObject>
#include <QString>

#include <deque>
#include <functional>

namespace angiopose::app {

/// Writes files off the GUI thread, one at a time in the order of the requests. Each task holds copies of its data and
/// returns the path to which it wrote. The destructor first completes all pending tasks.
class FileQueue : public QObject {
    Q_OBJECT
public:
    using Work = std::function<core::Result<QString>()>;
    using Callback = std::function<void(const core::Result<QString>& written)>;

    explicit FileQueue(QObject* parent = nullptr);
    ~FileQueue() override;

    void run(Work work, Callback callback);   ///< `answer` is called on this object's thread
    bool isBusy() const { return running_; }

private:
    struct Task {
        Work work;
        Callback callback;
    };
    void startNext();
    void publish();

    std::deque<Task> tasks_;   ///< the first task is the one in progress
    QFutureWatcher<core::Result<QString>> watcher_;
    bool running_ = false;
};

}   // namespace angiopose::app

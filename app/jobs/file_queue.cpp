#include "app/jobs/file_queue.h"

#include "app/jobs/guarded.h"

#include <QtConcurrentRun>

#include <utility>

namespace angiopose::app {

FileQueue::FileQueue(QObject* parent) : QObject(parent)
{
    connect(&watcher_, &QFutureWatcherBase::finished, this, &FileQueue::publish);
}

FileQueue::~FileQueue()
{
    if (running_) {
        (void)watcher_.result();   // waits for the worker, whose changes then become visible to this thread
    }
    watcher_.waitForFinished();
    for (std::size_t i = running_ ? 1 : 0; i < tasks_.size(); ++i) {
        (void)guarded<QString>(tasks_[i].work);
    }
}

void FileQueue::run(Work work, Callback callback)
{
    tasks_.push_back({std::move(work), std::move(callback)});
    if (!running_) {
        startNext();
    }
}

void FileQueue::startNext()
{
    running_ = !tasks_.empty();
    if (running_) {
        watcher_.setFuture(QtConcurrent::run([work = tasks_.front().work] { return guarded<QString>(work); }));
    }
}

void FileQueue::publish()
{
    const Task done = std::move(tasks_.front());
    tasks_.pop_front();
    const core::Result<QString> written = watcher_.result();
    startNext();
    if (done.callback) {
        done.callback(written);
    }
}

}   // namespace angiopose::app

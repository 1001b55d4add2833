#pragma once

#include "app/jobs/job.h"
#include "core/workflow/track_frames.h"

#include <QObject>

#include <vector>

namespace angiopose::app {

/// Runs core::trackFrames off the GUI thread: tracks the vessels through the frames of a cine run.
class TrackingJob : public QObject {
    Q_OBJECT
public:
    explicit TrackingJob(QObject* parent = nullptr);

    void start(core::Case session);
    void requestStop() { job_.requestStop(); }   ///< returns at once; the job then emits `finished`
    bool isRunning() const { return job_.isRunning(); }

signals:
    void progressed(double fraction);
    void finished(const std::vector<core::TrackedRunFrame>& frames);   ///< after a stop, only the frames tracked so far
    void failed(const core::Message& reason);

private:
    Job<std::vector<core::TrackedRunFrame>> job_;
};

}   // namespace angiopose::app

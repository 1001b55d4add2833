#pragma once

#include "app/jobs/job.h"
#include "core/imaging/angiogram.h"
#include "core/support/result.h"
#include "core/tracing/angiogram/trace_angiogram.h"
#include "core/vessel/centerline2d.h"

#include <QObject>

#include <memory>
#include <vector>

namespace angiopose::app {

/// Request to trace one frame. Holds copies of its data; the cine run is shared and immutable.
struct TraceRequest {
    std::shared_ptr<const core::Angiogram> angiogram;
    int frame = 0;
    core::TraceOptions options;

    bool operator==(const TraceRequest&) const = default;
};

using SharedCenterline = std::shared_ptr<const core::Centerline2d>;

/// Results of tracing one frame that the window shows.
struct TracedFrame {
    core::Centerline2d centerline;
    std::vector<int> suspectIds;
    core::Messages warnings;
    core::Mask2d fieldMask;   ///< 0 outside the field of view, which is not traced
};
using SharedTrace = std::shared_ptr<const TracedFrame>;

/// Traces one frame off the GUI thread. The destructor abandons the trace.
class TraceJob : public QObject {
    Q_OBJECT
public:
    explicit TraceJob(QObject* parent = nullptr);

    void start(TraceRequest request);
    bool isRunning() const { return job_.isRunning(); }

signals:
    void finished(const app::SharedTrace& traced);
    void failed(const core::Message& reason);

private:
    Job<SharedTrace> job_;
};

}   // namespace angiopose::app

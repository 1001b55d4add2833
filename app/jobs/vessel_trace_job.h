#pragma once

#include "app/jobs/job.h"
#include "core/case/case.h"
#include "core/support/result.h"

#include <QObject>

#include <memory>

namespace angiopose::app {

/// Input for tracing a vessel tree. A scan is taken from memory; any other input is read from its file again.
struct VesselTraceRequest {
    std::string path;
    core::VesselInput input;
    std::shared_ptr<const core::Volume> volume;
};

struct VesselTrace {
    core::VesselInput input;
    std::shared_ptr<const core::VoxelMask> lumen;
    std::shared_ptr<const core::VesselTree> tree;
    double threshold = 0.0;   ///< lower threshold of the lumen
    core::Messages warnings;
};

/// Traces a vessel tree off the GUI thread. A stop request takes effect within a second and leaves no result; the
/// destructor stops and abandons the trace.
class VesselTraceJob : public QObject {
    Q_OBJECT
public:
    explicit VesselTraceJob(QObject* parent = nullptr);

    void start(VesselTraceRequest request);
    void stop();
    bool isRunning() const { return job_.isRunning(); }

signals:
    void progressed(double fraction);
    void finished(const app::VesselTrace& traced);
    void failed(const core::Message& reason);
    void stopped();

private:
    Job<VesselTrace>::Callbacks callbacks();

    bool stopRequested_ = false;
    Job<VesselTrace> job_;
};

}   // namespace angiopose::app

#pragma once

#include "app/editing/mask_draft.h"
#include "app/jobs/job.h"
#include "app/jobs/vessel_trace_job.h"

namespace angiopose::app {

/// Traces the vessels of an edited mask on a worker, which borrows the draft until it has made a copy.
class MaskTracing : public QObject {
    Q_OBJECT
public:
    explicit MaskTracing(QObject* parent = nullptr);

    void start(const std::shared_ptr<MaskDraft>& draft, const core::VesselTracingOptions& options);
    void requestStop();
    bool isRunning() const { return job_.isRunning(); }

signals:
    void advanced(double fraction);
    void ended();   ///< emitted before each of the three signals below
    /// Vessels of the draft as it was after these strokes.
    void traced(const VesselTrace& trace, const std::shared_ptr<MaskDraft>& draft, const MaskDraft::Strokes& strokes);
    void stopped();
    void failed(const QString& reason);

private:
    void giveBack();
    void take(const VesselTrace& trace);
    void fail(const core::Error& error);

    std::shared_ptr<MaskDraft> draft_;
    MaskDraft::Strokes strokes_;
    bool isReading_ = false;   ///< the worker has not made its copy yet
    bool stopRequested_ = false;
    Job<VesselTrace> job_;
};

}   // namespace angiopose::app

#pragma once

#include "app/editing/mask_draft.h"
#include "app/jobs/job.h"
#include "app/jobs/vessel_trace_job.h"

namespace angiopose::app {

/// Traces the vessels of a mask that is being edited, on a worker, which borrows the draft until it has its copy.
class MaskTracing : public QObject {
    Q_OBJECT
public:
    explicit MaskTracing(QObject* parent = nullptr);

    void start(const std::shared_ptr<MaskDraft>& draft, const core::VesselTracingOptions& options);
    void requestStop();
    bool isRunning() const { return job_.isRunning(); }

signals:
    void advanced(double fraction);
    void ended();   ///< before each of the three below
    /// Of this draft as it was when these strokes had been made.
    void traced(const VesselTrace& trace, const std::shared_ptr<MaskDraft>& draft, const MaskDraft::Strokes& strokes);
    void stopped();
    void failed(const QString& reason);

private:
    void giveBack();
    void take(const VesselTrace& trace);
    void fail(const core::Error& error);

    std::shared_ptr<MaskDraft> draft_;
    MaskDraft::Strokes strokes_;
    bool isReading_ = false;   ///< the worker has no copy yet
    bool stopRequested_ = false;
    Job<VesselTrace> job_;
};

}   // namespace angiopose::app

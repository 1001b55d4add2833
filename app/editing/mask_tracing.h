#pragma once

#include "app/editing/mask_draft.h"
#include "app/jobs/job.h"
#include "app/jobs/vessel_trace_job.h"

namespace angiopose::app {

/// Traces the vessels of an edited mask on a worker. The draft does not change until the worker has copied the mask.
class MaskTracer : public QObject {
    Q_OBJECT
public:
    explicit MaskTracer(QObject* parent = nullptr);

    void start(const std::shared_ptr<MaskDraft>& draft, const core::VesselTracingOptions& options);
    void requestStop();
    bool isRunning() const { return job_.isRunning(); }

signals:
    void progressed(double fraction);
    void ended();   ///< emitted before each of the three signals below
    /// Emitted with the vessels traced from the draft in its state after `strokes`.
    void traced(const VesselTrace& trace, const std::shared_ptr<MaskDraft>& draft, const MaskDraft::Strokes& strokes);
    void stopped();
    void failed(const QString& reason);

private:
    void releaseDraft();
    void finish(const VesselTrace& trace);
    void fail(const core::Error& error);

    std::shared_ptr<MaskDraft> draft_;
    MaskDraft::Strokes strokes_;
    bool isReading_ = false;   ///< true until the worker has made a copy of the draft
    bool stopRequested_ = false;
    Job<VesselTrace> job_;
};

}   // namespace angiopose::app

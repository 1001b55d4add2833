#include "app/editing/mask_tracing.h"

#include "core/tracing/volume/trace_vessels.h"
#include "ui/words/message_text.h"

#include <algorithm>
#include <utility>

namespace angiopose::app {
namespace {

using core::VoxelMask;

/// Copies the mask for the case and traces its vessels, for which only the last stages of tracing are needed.
core::Result<VesselTrace> traceOf(const VoxelMask& draft, const core::VesselTracingOptions& options,
                                  JobLink<double>& link)
{
    const auto mask = std::make_shared<const VoxelMask>(draft);
    link.tell(0.0);   // the copy is complete, so that the draft may change again
    auto traced = core::traceMask(*mask, options, [&link](const core::TracingReport& report) {
        return link.tell(std::max(report.progress, 0.001));
    });
    if (!traced) {
        return traced.error();
    }
    core::TracedVessels vessels = std::move(traced).value();
    VesselTrace found;
    found.input.kind = core::VesselInputKind::Segmentation;
    found.input.tracing = options;
    found.lumen = mask;
    found.tree = std::make_shared<const core::VesselTree>(std::move(vessels.tree));
    found.warnings = std::move(vessels.warnings);
    return found;
}

}   // namespace

MaskTracer::MaskTracer(QObject* parent)
    : QObject(parent),
      job_({[this](const VesselTrace& trace) { finish(trace); }, [this](const core::Error& error) { fail(error); },
            [this](double fraction) {
                releaseDraft();
                emit progressed(fraction);
            }})
{
}

void MaskTracer::start(const std::shared_ptr<MaskDraft>& draft, const core::VesselTracingOptions& options)
{
    draft_ = draft;
    strokes_ = draft->strokes();
    stopRequested_ = false;
    isReading_ = true;
    draft_->beginReading();
    job_.start([mask = std::shared_ptr<const VoxelMask>(draft->mask()), options](JobLink<double>& link) {
        return traceOf(*mask, options, link);
    });
}

void MaskTracer::requestStop()
{
    stopRequested_ = isRunning();
    job_.requestStop();
}

void MaskTracer::releaseDraft()
{
    if (std::exchange(isReading_, false)) {
        draft_->endReading();
    }
}

void MaskTracer::finish(const VesselTrace& trace)
{
    releaseDraft();
    emit ended();
    emit traced(trace, std::exchange(draft_, nullptr), strokes_);
}

void MaskTracer::fail(const core::Error& error)
{
    releaseDraft();
    draft_.reset();
    emit ended();
    if (stopRequested_) {
        emit stopped();
    } else {
        emit failed(ui::messageText(error.message));
    }
}

}   // namespace angiopose::app

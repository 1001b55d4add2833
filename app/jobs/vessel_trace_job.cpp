#include "app/jobs/vessel_trace_job.h"

#include "io/vessel_input_file.h"

namespace angiopose::app {
namespace {

/// Traces a scan that is in memory; reads any other input from its file again.
core::Result<VesselTrace> traceVessels(const VesselTraceRequest& request, const io::ReadObserver& observe)
{
    const bool isScan = request.volume && request.input.kind == core::VesselInputKind::Volume;
    auto outcome = isScan ? io::traceScan(request.volume, request.path, request.input, observe)
                          : io::readVessels(request.path, request.input, observe);
    if (!outcome) {
        return outcome.error();
    }
    io::LoadedVessels vessels = std::move(outcome).value();
    VesselTrace traced;
    traced.input = vessels.input;
    traced.lumen = io::takeSharedLumen(vessels);
    traced.tree = std::make_shared<const core::VesselTree>(std::move(vessels.tree));
    traced.threshold = vessels.threshold;
    traced.warnings = vessels.warnings;
    return traced;
}

}   // namespace

VesselTraceJob::VesselTraceJob(QObject* parent) : QObject(parent), job_(callbacks()) {}

/// Returns callbacks that, after a stop request, emit only `stopped`, even if the trace has completed in the meantime.
Job<VesselTrace>::Callbacks VesselTraceJob::callbacks()
{
    const auto unlessStopped = [this](const auto& answer) {
        if (stopRequested_) {
            emit stopped();
        } else {
            answer();
        }
    };
    return {[this, unlessStopped](const VesselTrace& traced) { unlessStopped([&] { emit finished(traced); }); },
            [this, unlessStopped](const core::Error& error) { unlessStopped([&] { emit failed(error.message); }); },
            [this](double fraction) { emit progressed(fraction); }};
}

void VesselTraceJob::start(VesselTraceRequest request)
{
    Q_ASSERT(!isRunning());
    stopRequested_ = false;
    job_.start([request = std::move(request)](JobLink<double>& link) {
        const io::ReadObserver observe = [&link](double fraction) { return link.tell(fraction); };
        return traceVessels(request, observe);
    });
}

void VesselTraceJob::stop()
{
    stopRequested_ = true;
    job_.requestStop();
}

}   // namespace angiopose::app

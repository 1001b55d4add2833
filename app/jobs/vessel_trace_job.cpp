#include "app/jobs/vessel_trace_job.h"

#include "core/tracing/volume/trace_vessels.h"
#include "io/vessel_input_file.h"

namespace angiopose::app {
namespace {

core::Result<VesselTrace> traceScan(const VesselTraceRequest& request, const io::ReadObserver& observe)
{
    auto traced =
        core::traceVessels(*request.volume, request.input.tracing,
                           [&observe](const core::TracingReport& report) { return observe(report.progress); });
    if (!traced) {
        return traced.error();
    }
    core::TracedVessels vessels = std::move(traced).value();
    return VesselTrace{request.input, std::make_shared<const core::VoxelMask>(std::move(vessels.lumen)),
                       std::make_shared<const core::VesselTree>(std::move(vessels.tree)), vessels.threshold,
                       vessels.warnings};
}

core::Result<VesselTrace> traceFile(const VesselTraceRequest& request, const io::ReadObserver& observe)
{
    auto read = io::readVessels(request.path, request.input, observe);
    if (!read) {
        return read.error();
    }
    io::LoadedVessels vessels = std::move(read).value();
    VesselTrace traced;
    traced.input = vessels.input;
    traced.lumen = io::sharedLumen(vessels);
    traced.tree = std::make_shared<const core::VesselTree>(std::move(vessels.tree));
    traced.threshold = vessels.threshold;
    traced.warnings = vessels.warnings;
    return traced;
}

}   // namespace

VesselTraceJob::VesselTraceJob(QObject* parent) : QObject(parent), job_(answers()) {}

/// Stopped is stopped, even where the end was near.
Job<VesselTrace>::Answers VesselTraceJob::answers()
{
    const auto unlessStopped = [this](const auto& answer) {
        if (stopWished_) {
            emit stopped();
        } else {
            answer();
        }
    };
    return {[this, unlessStopped](const VesselTrace& traced) { unlessStopped([&] { emit finished(traced); }); },
            [this, unlessStopped](const core::Error& error) { unlessStopped([&] { emit failed(error.message); }); },
            [this](double fraction) { emit advanced(fraction); }};
}

void VesselTraceJob::start(VesselTraceRequest request)
{
    Q_ASSERT(!isRunning());
    stopWished_ = false;
    job_.start([request = std::move(request)](JobLink<double>& link) {
        const io::ReadObserver observe = [&link](double fraction) { return link.tell(fraction); };
        const bool isScan = request.volume && request.input.kind == core::VesselInputKind::Volume;
        return isScan ? traceScan(request, observe) : traceFile(request, observe);
    });
}

void VesselTraceJob::stop()
{
    stopWished_ = true;
    job_.requestStop();
}

}   // namespace angiopose::app

#include "app/jobs/vessel_trace_job.h"

#include "app/jobs/future_result.h"
#include "app/jobs/guarded.h"
#include "app/jobs/publish_outcome.h"
#include "core/tracing/volume/trace_vessels.h"
#include "io/vessel_input_file.h"

#include <QtConcurrentRun>

namespace angiopose::app {
namespace {

constexpr int tracePollMs = 60;

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

VesselTraceJob::VesselTraceJob(QObject* parent) : QObject(parent)
{
    connect(&watcher_, &QFutureWatcherBase::finished, this, &VesselTraceJob::publish);
    poll_.setInterval(tracePollMs);
    connect(&poll_, &QTimer::timeout, this, [this] { emit advanced(shared_->fraction); });
}

VesselTraceJob::~VesselTraceJob()
{
    stop();
}

void VesselTraceJob::start(VesselTraceRequest request)
{
    Q_ASSERT(!isRunning());
    running_ = true;
    shared_ = std::make_shared<Shared>();
    poll_.start();
    watcher_.setFuture(QtConcurrent::run([request = std::move(request), shared = shared_] {
        const io::ReadObserver observe = [&shared](double fraction) {
            shared->fraction = fraction;
            return shared->isStopWished ? core::Verdict::Stop : core::Verdict::Continue;
        };
        return guarded<VesselTrace>([&] {
            const bool isScan = request.volume && request.input.kind == core::VesselInputKind::Volume;
            return isScan ? traceScan(request, observe) : traceFile(request, observe);
        });
    }));
}

void VesselTraceJob::stop()
{
    shared_->isStopWished = true;
}

void VesselTraceJob::publish()
{
    running_ = false;
    poll_.stop();
    const auto outcome = takeResult(watcher_);
    if (shared_->isStopWished) {
        emit stopped();
    } else {
        publishOutcome(*this, outcome);
    }
}

}   // namespace angiopose::app
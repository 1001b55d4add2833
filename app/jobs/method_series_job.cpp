#include "app/jobs/method_series_job.h"

#include <utility>

namespace angiopose::app {

MethodSeriesJob::MethodSeriesJob(QObject* parent)
    : QObject(parent),
      job_({[this](const core::Done&) { emit ended(stopRequested_); }, [this](const core::Error&) { emit ended(true); },
            [this](const Report& report) { tell(report); }})
{
}

void MethodSeriesJob::start(core::RegistrationInput input, core::RegistrationOptions options,
                            std::vector<std::string> methodIds)
{
    Q_ASSERT(!isRunning());
    reportedCount_ = 0;
    stopRequested_ = false;
    job_.start([input = std::move(input), options = std::move(options), methodIds = std::move(methodIds)](
                   JobLink<Report>& link) { return solve(input, options, methodIds, link); });
}

void MethodSeriesJob::requestStop()
{
    stopRequested_ = true;
    job_.requestStop();
}

core::Result<core::Done> MethodSeriesJob::solve(const core::RegistrationInput& input, core::RegistrationOptions options,
                                                const std::vector<std::string>& methodIds, JobLink<Report>& link)
{
    Report report;
    const double share = 1.0 / static_cast<double>(methodIds.size());
    for (std::size_t i = 0; i < methodIds.size() && link.decision() == core::ObserverDecision::Continue; ++i) {
        options.method = report.methodId = methodIds[i];
        const auto observe = [&](const core::IterationReport& iteration) {
            report.progress = share * (static_cast<double>(i) + iteration.progress);
            return link.tell(report);
        };
        auto outcome =
            guarded<core::RegistrationResult>([&] { return core::registerVessels(input, options, observe); });
        if (!outcome || outcome.value().stopReason != core::StopReason::StoppedByUser) {
            report.ended.push_back({options.method, std::move(outcome)});
        }
        report.progress = share * static_cast<double>(i + 1);
        link.tell(report);
    }
    return core::Done{};
}

void MethodSeriesJob::tell(const Report& report)
{
    emit progressed(QString::fromStdString(report.methodId), report.progress);
    for (; reportedCount_ < report.ended.size(); ++reportedCount_) {
        const MethodOutcome& method = report.ended[reportedCount_];
        if (method.outcome) {
            emit solved(method.outcome.value());
        } else {
            emit failed(QString::fromStdString(method.methodId), method.outcome.error().message);
        }
    }
}

}   // namespace angiopose::app

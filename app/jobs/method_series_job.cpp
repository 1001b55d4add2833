#include "app/jobs/method_series_job.h"

#include "app/jobs/guarded.h"

#include <QtConcurrentRun>

#include <chrono>
#include <utility>

namespace angiopose::app {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds seriesReportPause{50};

}   // namespace

MethodSeriesJob::MethodSeriesJob(QObject* parent) : QObject(parent)
{
    connect(&watcher_, &QFutureWatcherBase::finished, this, [this] {
        running_ = false;
        emit ended(stopRequested_);
    });
}

MethodSeriesJob::~MethodSeriesJob()
{
    requestStop();
    watcher_.waitForFinished();
}

void MethodSeriesJob::start(core::RegistrationInput input, core::RegistrationOptions options,
                            std::vector<std::string> methodIds)
{
    Q_ASSERT(!running_);
    running_ = true;
    stopRequested_ = false;
    watcher_.setFuture(QtConcurrent::run([this, input = std::move(input), options = std::move(options),
                                          methodIds = std::move(methodIds)] { solve(input, options, methodIds); }));
}

void MethodSeriesJob::solve(const core::RegistrationInput& input, core::RegistrationOptions options,
                            const std::vector<std::string>& methodIds)
{
    const double share = 1.0 / static_cast<double>(methodIds.size());
    for (std::size_t i = 0; i < methodIds.size() && !stopRequested_; ++i) {
        options.method = methodIds[i];
        solveOne(input, options, share * static_cast<double>(i), share);
    }
}

void MethodSeriesJob::solveOne(const core::RegistrationInput& input, const core::RegistrationOptions& options,
                               double done, double share)
{
    const QString id = QString::fromStdString(options.method);
    const auto report = [this, id](double progress) {
        QMetaObject::invokeMethod(
            this, [this, id, progress] { emit advanced(id, progress); }, Qt::QueuedConnection);
    };
    report(done);
    Clock::time_point last{};
    const auto observe = [&](const core::IterationReport& iteration) {
        if (const auto now = Clock::now(); now - last > seriesReportPause) {
            last = now;
            report(done + share * iteration.progress);
        }
        return stopRequested_ ? core::Verdict::Stop : core::Verdict::Continue;
    };
    const auto outcome =
        guarded<core::RegistrationResult>([&] { return core::registerVessels(input, options, observe); });
    if (!outcome) {
        const core::Message reason = outcome.error().message;
        QMetaObject::invokeMethod(
            this, [this, id, reason] { emit failed(id, reason); }, Qt::QueuedConnection);
    } else if (outcome.value().stopReason != core::StopReason::StoppedByUser) {
        QMetaObject::invokeMethod(
            this, [this, result = outcome.value()] { emit solved(result); }, Qt::QueuedConnection);
    }
}

}   // namespace angiopose::app
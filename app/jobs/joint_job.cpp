#include "app/jobs/joint_job.h"

#include "app/jobs/future_result.h"
#include "app/jobs/guarded.h"
#include "app/jobs/publish_outcome.h"
#include "app/messages/says.h"
#include "core/case/case_views.h"
#include "core/case/registration_input.h"

#include <QtConcurrentRun>

#include <chrono>
#include <utility>

namespace angiopose::app {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds jointReportPause{33};   // what the eye can follow

core::Result<std::vector<core::Centerline2d>> targetsOf(const std::vector<core::View>& views, core::Centerline2d target,
                                                        const std::atomic<bool>& isStopped)
{
    std::vector<core::Centerline2d> targets{std::move(target)};
    for (std::size_t k = 1; k < views.size(); ++k) {
        auto traced = isStopped ? core::Result<core::Centerline2d>(core::Stopped{says::stoppedBeforeRun()})
                                : core::targetOf(views[k]);
        if (!traced) {
            return core::inView(k, traced.error());
        }
        targets.push_back(std::move(traced).value());
    }
    return targets;
}

}   // namespace

JointJob::JointJob(QObject* parent) : QObject(parent)
{
    connect(&watcher_, &QFutureWatcherBase::finished, this, &JointJob::publish);
}

JointJob::~JointJob()
{
    requestStop();
    waitFor(watcher_);
}

void JointJob::start(core::Case theCase, core::Centerline2d target)
{
    Q_ASSERT(!watcher_.isRunning());
    stopRequested_ = false;
    watcher_.setFuture(
        QtConcurrent::run([this, theCase = std::move(theCase), target = std::move(target)]() mutable -> Outcome {
            return guarded<core::MultiViewResult>([&] { return solve(theCase, std::move(target)); });
        }));
}

JointJob::Outcome JointJob::solve(const core::Case& theCase, core::Centerline2d target)
{
    const std::vector<core::View> views = core::viewsAt(theCase, core::registeredViews(theCase));
    const auto begin = Clock::now();
    const auto targets = targetsOf(views, std::move(target), stopRequested_);
    if (!targets) {
        return targets.error();
    }
    const auto inputs = core::jointInputsOf(views, theCase.vessels, targets.value());
    if (!inputs) {
        return inputs.error();
    }
    Clock::time_point last{};
    const auto observe = [this, &last](const core::IterationReport& report) {
        if (const auto now = Clock::now(); now - last > jointReportPause) {
            last = now;
            QMetaObject::invokeMethod(
                this, [this, report] { emit advanced(report); }, Qt::QueuedConnection);
        }
        return stopRequested_ ? core::Verdict::Stop : core::Verdict::Continue;
    };
    auto solved = core::registerViews(inputs.value(), theCase.options, {}, observe);
    if (!solved) {
        return solved.error();
    }
    core::MultiViewResult joint = std::move(solved).value();
    for (core::RegistrationResult& view : joint.views) {   // one run found them all
        view.time.totalMs = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
    }
    return joint;
}

void JointJob::publish()
{
    publishOutcome(*this, takeResult(watcher_));
}

}   // namespace angiopose::app
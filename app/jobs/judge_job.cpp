#include "app/jobs/judge_job.h"

#include "app/jobs/future_result.h"
#include "app/jobs/guarded.h"
#include "core/evaluation/trial/branch_distances.h"

#include <QtConcurrentRun>

#include <utility>

namespace angiopose::app {
namespace {

core::Result<SharedJudgement> judge(const JudgeRequest& request)
{
    auto result = core::evaluatePose(request.input, request.cameraFromPatient);
    if (!result) {
        return result.error();
    }
    const core::RegistrationInput& input = request.input;
    auto judgement = std::make_shared<Judgement>();
    judgement->result = std::move(result).value();
    judgement->residualPx = core::branchDistances(input.tree, input.target, input.camera, request.cameraFromPatient);
    return SharedJudgement(std::move(judgement));
}

}   // namespace

JudgeJob::JudgeJob(QObject* parent) : QObject(parent)
{
    connect(&watcher_, &QFutureWatcherBase::finished, this, &JudgeJob::publish);
}

void JudgeJob::request(JudgeRequest request)
{
    if (running_) {
        waiting_ = std::move(request);
    } else {
        start(std::move(request));
    }
}

void JudgeJob::cancel()
{
    waiting_.reset();
    cancelled_ = running_;
}

void JudgeJob::start(JudgeRequest request)
{
    running_ = true;
    cancelled_ = false;
    watcher_.setFuture(QtConcurrent::run(
        [snapshot = std::move(request)] { return guarded<SharedJudgement>([&snapshot] { return judge(snapshot); }); }));
}

void JudgeJob::publish()
{
    running_ = false;
    const auto outcome = takeResult(watcher_);
    const bool wanted = !std::exchange(cancelled_, false);
    if (waiting_) {
        start(*std::exchange(waiting_, std::nullopt));
    }
    if (!wanted) {
        return;
    }
    if (outcome) {
        emit judged(outcome.value());
    } else {
        emit failed(outcome.error().message);
    }
}

}   // namespace angiopose::app
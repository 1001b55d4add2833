#include "app/jobs/judge_job.h"

#include <utility>

namespace angiopose::app {
namespace {

core::Result<SharedJudgement> judge(const JudgeRequest& request)
{
    auto judged = core::judgementOf(request.input, request.cameraFromPatient);
    if (!judged) {
        return judged.error();
    }
    return std::make_shared<const core::PoseJudgement>(std::move(judged).value());
}

}   // namespace

JudgeJob::JudgeJob(std::chrono::milliseconds rest, QObject* parent)
    : QObject(parent),
      job_({[this](const SharedJudgement& judgement) {
                goOn();
                emit judged(judgement);
            },
            [this](const core::Error& error) {
                goOn();
                emit failed(error.message);
            }})
{
    rest_.setSingleShot(true);
    rest_.setInterval(rest);
    connect(&rest_, &QTimer::timeout, this, &JudgeJob::startWaiting);
}

void JudgeJob::request(JudgeRequest request)
{
    if (job_.isRunning() || rest_.isActive()) {
        waiting_ = std::move(request);
    } else {
        start(std::move(request));
    }
}

void JudgeJob::cancel()
{
    waiting_.reset();
    job_.drop();
}

void JudgeJob::start(JudgeRequest request)
{
    job_.start([request = std::move(request)](JobLink<double>&) { return judge(request); });
}

void JudgeJob::goOn()
{
    if (rest_.interval() > 0) {
        rest_.start();
    } else {
        startWaiting();
    }
}

void JudgeJob::startWaiting()
{
    if (waiting_) {
        start(*std::exchange(waiting_, std::nullopt));
    }
}

}   // namespace angiopose::app

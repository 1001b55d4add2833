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

JudgeJob::JudgeJob(QObject* parent)
    : QObject(parent),
      job_({[this](const SharedJudgement& judgement) {
                startWaiting();
                emit judged(judgement);
            },
            [this](const core::Error& error) {
                startWaiting();
                emit failed(error.message);
            }})
{
}

void JudgeJob::request(JudgeRequest request)
{
    if (job_.isRunning()) {
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

void JudgeJob::startWaiting()
{
    if (waiting_) {
        start(*std::exchange(waiting_, std::nullopt));
    }
}

}   // namespace angiopose::app

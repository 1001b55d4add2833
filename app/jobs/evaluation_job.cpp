#include "app/jobs/evaluation_job.h"

#include <utility>

namespace angiopose::app {
namespace {

core::Result<SharedEvaluation> judge(const EvaluationRequest& request)
{
    auto evaluated = core::evaluateWithResiduals(request.input, request.cameraFromPatient);
    if (!evaluated) {
        return evaluated.error();
    }
    return std::make_shared<const core::PoseEvaluation>(std::move(evaluated).value());
}

}   // namespace

EvaluationJob::EvaluationJob(std::chrono::milliseconds pause, QObject* parent)
    : QObject(parent),
      job_({[this](const SharedEvaluation& evaluation) {
                startNext();
                emit evaluated(evaluation);
            },
            [this](const core::Error& error) {
                startNext();
                emit failed(error.message);
            }})
{
    pauseTimer_.setSingleShot(true);
    pauseTimer_.setInterval(pause);
    connect(&pauseTimer_, &QTimer::timeout, this, &EvaluationJob::startPending);
}

void EvaluationJob::request(EvaluationRequest request)
{
    if (job_.isRunning() || pauseTimer_.isActive()) {
        pending_ = std::move(request);
    } else {
        start(std::move(request));
    }
}

void EvaluationJob::cancel()
{
    pending_.reset();
    job_.drop();
}

void EvaluationJob::start(EvaluationRequest request)
{
    job_.start([request = std::move(request)](JobLink<double>&) { return judge(request); });
}

void EvaluationJob::startNext()
{
    if (pauseTimer_.interval() > 0) {
        pauseTimer_.start();
    } else {
        startPending();
    }
}

void EvaluationJob::startPending()
{
    if (pending_) {
        start(*std::exchange(pending_, std::nullopt));
    }
}

}   // namespace angiopose::app

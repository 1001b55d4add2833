#pragma once

#include "app/jobs/job.h"
#include "core/workflow/pose_evaluation.h"

#include <QObject>
#include <QTimer>

#include <chrono>
#include <memory>
#include <optional>

namespace angiopose::app {

/// Request to evaluate a pose. All data are copies, or shared and immutable.
struct EvaluationRequest {
    core::RegistrationInput input;   ///< its target is the reference with which the tree is compared
    core::RigidTransform cameraFromPatient;
};

using SharedEvaluation = std::shared_ptr<const core::PoseEvaluation>;

/// Evaluates poses off the GUI thread, always the newest one: a request made during an evaluation, or shortly after
/// one, replaces the pending request.
class EvaluationJob : public QObject {
    Q_OBJECT
public:
    /// `rest` is the pause between an outcome and the next evaluation, which leaves processor time for other work.
    explicit EvaluationJob(std::chrono::milliseconds pause = {}, QObject* parent = nullptr);

    void request(EvaluationRequest request);
    void cancel();   ///< drops the pending request and the evaluation in progress

signals:
    void evaluated(const app::SharedEvaluation& evaluation);
    void failed(const core::Message& reason);

private:
    void start(EvaluationRequest request);
    void startNext();
    void startPending();

    std::optional<EvaluationRequest> pending_;
    QTimer pauseTimer_;
    Job<SharedEvaluation> job_;
};

}   // namespace angiopose::app

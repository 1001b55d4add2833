#pragma once

#include "app/jobs/job.h"
#include "core/workflow/pose_judgement.h"

#include <QObject>
#include <QTimer>

#include <chrono>
#include <memory>
#include <optional>

namespace angiopose::app {

/// Request to evaluate a pose; all data by value, or shared and constant.
struct JudgeRequest {
    core::RegistrationInput input;   ///< its target is the reference for the tree
    core::RigidTransform cameraFromPatient;
};

using SharedJudgement = std::shared_ptr<const core::PoseJudgement>;

/// Evaluates poses off the GUI thread, always the newest: a request that arrives during an evaluation, or shortly after
/// it, replaces the waiting one.
class JudgeJob : public QObject {
    Q_OBJECT
public:
    /// `rest`: pause between an outcome and the next request, which leaves processor time for other work.
    explicit JudgeJob(std::chrono::milliseconds rest = {}, QObject* parent = nullptr);

    void request(JudgeRequest request);
    void cancel();   ///< drops the waiting request and the outcome of the running one

signals:
    void judged(const app::SharedJudgement& judgement);
    void failed(const core::Message& reason);

private:
    void start(JudgeRequest request);
    void goOn();
    void startWaiting();

    std::optional<JudgeRequest> waiting_;
    QTimer rest_;
    Job<SharedJudgement> job_;
};

}   // namespace angiopose::app
#pragma once

#include "app/jobs/job.h"
#include "core/workflow/pose_judgement.h"

#include <QObject>
#include <QTimer>

#include <chrono>
#include <memory>
#include <optional>

namespace angiopose::app {

/// Request to evaluate a pose. All data are copies, or shared and immutable.
struct JudgeRequest {
    core::RegistrationInput input;   ///< its target is the reference to which the tree is compared
    core::RigidTransform cameraFromPatient;
};

using SharedJudgement = std::shared_ptr<const core::PoseJudgement>;

/// Evaluates poses off the GUI thread, always the newest one: a request made during an evaluation, or shortly after
/// one, replaces the pending request.
class JudgeJob : public QObject {
    Q_OBJECT
public:
    /// `rest` is the pause between an outcome and the next evaluation, which leaves processor time for other work.
    explicit JudgeJob(std::chrono::milliseconds rest = {}, QObject* parent = nullptr);

    void request(JudgeRequest request);
    void cancel();   ///< drops the pending request and the evaluation in progress

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

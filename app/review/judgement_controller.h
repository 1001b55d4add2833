#pragma once

#include "app/document/case_document.h"
#include "app/editing/pose_controller.h"
#include "app/jobs/judge_job.h"
#include "app/registration/registration_controller.h"
#include "app/registration/target_provider.h"
#include "app/review/look_controller.h"
#include "app/review/replay_controller.h"
#include "app/review/view_sync.h"
#include "ui/panels/result_panel.h"

#include <QObject>

namespace ui {
class MainWindow;
}

namespace app {

/// Judges the pose that is shown, off the window's thread, and shows the verdict: numbers, sentences, residual colours.
class JudgementController : public QObject {
    Q_OBJECT
public:
    /// What the verdict is made from and who shows it.
    struct Parts {
        const CaseDocument& document;
        const TargetProvider& target;
        const PoseController& pose;
        const RegistrationController& registration;
        ViewSync& sync;
        LookController& look;
        ReplayController& replay;
        ui::MainWindow& window;
    };
    explicit JudgementController(const Parts& parts, QObject* parent = nullptr);

    void judge(const core::RigidTransform& cameraFromPatient);
    void show();
    const SharedJudgement& current() const { return judgement_; }

signals:
    void judged(const app::SharedJudgement& judgement);

private:
    ui::JudgedPose judgedPose(const core::ProjectionCamera& camera) const;
    void showNothing();

    Parts on_;
    JudgeJob job_;
    SharedJudgement judgement_;
};

}   // namespace app

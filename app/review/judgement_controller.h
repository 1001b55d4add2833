#pragma once

#include "app/document/case_document.h"
#include "app/editing/pose_controller.h"
#include "app/jobs/judge_job.h"
#include "app/registration/registration_controller.h"
#include "app/registration/target_provider.h"
#include "app/review/look_controller.h"
#include "app/review/replay_controller.h"
#include "app/showing/view_sync.h"
#include "app/texts/word_of_run.h"
#include "ui/panels/pose_panel.h"
#include "ui/panels/result_panel.h"

#include <QObject>

namespace angiopose::ui {
class ResultPanel;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Evaluates the shown pose off the GUI thread and shows the verdict as numbers, sentences and residual colors.
class JudgementController : public QObject {
    Q_OBJECT
public:
    /// Inputs of the verdict, and the objects that show it.
    struct Parts {
        const CaseDocument& document;
        const TargetProvider& target;
        const PoseController& pose;
        const RegistrationController& registration;
        ViewSync& sync;
        LookController& look;
        ReplayController& replay;
        ui::ResultPanel& panel;
        ui::PosePanel& posePanel;
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
    ui::PoseSource sourceOf(FoundBy found) const;

    Parts on_;
    JudgeJob job_;
    SharedJudgement judgement_;
};

}   // namespace angiopose::app

#pragma once

#include "app/document/case_document.h"
#include "app/editing/pose_controller.h"
#include "app/jobs/evaluation_job.h"
#include "app/registration/registration_controller.h"
#include "app/registration/target_provider.h"
#include "app/review/overlay_style_controller.h"
#include "app/review/replay_controller.h"
#include "app/showing/view_sync.h"
#include "app/texts/pose_origin.h"
#include "ui/panels/pose_panel.h"
#include "ui/panels/result_panel.h"

#include <QObject>

namespace angiopose::ui {
class ResultPanel;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Evaluates the shown pose off the GUI thread and shows the verdict as numbers, sentences and residual colors.
class EvaluationController : public QObject {
    Q_OBJECT
public:
    /// Inputs of the verdict, and the objects that show it.
    struct Parts {
        const CaseDocument& document;
        const TargetProvider& target;
        const PoseController& pose;
        const RegistrationController& registration;
        ViewSync& sync;
        OverlayStyleController& overlayStyle;
        ReplayController& replay;
        ui::ResultPanel& panel;
        ui::PosePanel& posePanel;
    };
    explicit EvaluationController(const Parts& parts, QObject* parent = nullptr);

    void evaluate(const core::RigidTransform& cameraFromPatient);
    void show();
    const SharedEvaluation& current() const { return evaluation_; }

signals:
    void evaluated(const app::SharedEvaluation& evaluation);

private:
    ui::AssessedPose evaluatedPose(const core::ProjectionCamera& camera) const;
    void showNothing();
    ui::PoseSource sourceOf(PoseOrigin found) const;

    Parts parts_;
    EvaluationJob job_;
    SharedEvaluation evaluation_;
};

}   // namespace angiopose::app

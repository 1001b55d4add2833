#pragma once

#include "app/editing/pose_controller.h"
#include "app/review/evaluation_controller.h"
#include "app/showing/notifications.h"
#include "app/showing/pose_preview.h"
#include "app/showing/review_controller.h"
#include "ui/views/tools/nudge_tool.h"

#include <QObject>

namespace angiopose::ui {
class AngiogramView;
class PosePanel;
class RegistrationPanel;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Manages manual pose adjustment: the pose panel, nudge mode with keys and drags, and the live preview in all views.
class PoseGestures : public QObject {
    Q_OBJECT
public:
    /// Objects that hold and show the pose.
    struct Parts {
        const CaseDocument& document;
        PoseController& pose;
        ReviewController& review;
        EvaluationController& evaluation;
        PosePreview& preview;
        Notifications& notifications;
        ui::WindowActions& actions;
        ui::PosePanel& panel;
        ui::RegistrationPanel& registration;
        ui::AngiogramView& view;
    };
    explicit PoseGestures(const Parts& parts, QObject* parent = nullptr);

    void show();   ///< updates the displayed offsets and locks from the case

private:
    void connectPanel();
    void connectTool();
    void showNudgeMode(bool on);
    void preview(const core::RigidTransform& pose);
    void endPreview();
    void copyMatrix();

    Parts parts_;
    ui::NudgeTool* tool_;   ///< owned by the view
};

}   // namespace angiopose::app

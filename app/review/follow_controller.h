#pragma once

#include "app/files/export_controller.h"
#include "app/jobs/follow_job.h"
#include "app/review/judgement_controller.h"
#include "app/showing/notices.h"
#include "app/showing/review_controller.h"
#include "app/showing/view_sync.h"

#include <QObject>

#include <optional>
#include <vector>

namespace angiopose::ui {
class BottomStrip;
class ResultPanel;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Follows the vessels through the frames of the run from the frame and pose that are shown, then shows each frame with
/// its own pose. The poses hold until something else moves the vessels.
class FollowController : public QObject {
    Q_OBJECT
public:
    /// What it works on and tells.
    struct Parts {
        CaseDocument& document;
        ReviewController& review;
        JudgementController& judgement;
        ViewSync& sync;
        PosePreview& preview;
        ExportController& exporting;
        Notices& notices;
        ui::WindowActions& actions;
        ui::ResultPanel& panel;
        ui::BottomStrip& strip;
    };
    explicit FollowController(const Parts& parts, QObject* parent = nullptr);

    bool isRunning() const { return job_.isRunning(); }
    const std::vector<core::FollowedFrame>& frames() const { return frames_; }

private:
    QString whyNot() const;
    void start();
    void take(const std::vector<core::FollowedFrame>& frames);
    void followDocument();
    void showFrame(int frame);
    void showMotion();
    void forget();
    void exportPoses();
    bool holds() const;
    std::optional<core::RigidTransform> poseOf(int frame) const;

    Parts on_;
    FollowJob job_;
    core::Case startedFrom_;
    std::vector<core::FollowedFrame> frames_;
};

}   // namespace angiopose::app
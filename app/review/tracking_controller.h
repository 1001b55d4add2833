#pragma once

#include "app/files/export_controller.h"
#include "app/jobs/tracking_job.h"
#include "app/showing/notifications.h"
#include "app/showing/review_controller.h"
#include "app/showing/view_sync.h"

#include <QObject>

#include <memory>
#include <vector>

namespace angiopose::ui {
class BottomStrip;
class ResultPanel;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Tracks the vessels through the cine run, starting from the shown frame and pose; the result is one undo step. Shows
/// each frame with its tracked pose as long as the case has a tracking result.
class TrackingController : public QObject {
    Q_OBJECT
public:
    /// Objects that the controller works with.
    struct Parts {
        CaseDocument& document;
        ReviewController& review;
        ViewSync& sync;
        PosePreview& preview;
        ExportController& exportController;
        Notifications& notifications;
        ui::WindowActions& actions;
        ui::ResultPanel& panel;
        ui::BottomStrip& strip;
    };
    explicit TrackingController(const Parts& parts, QObject* parent = nullptr);

    bool isRunning() const { return job_.isRunning(); }
    const std::vector<core::TrackedRunFrame>& frames() const
    {
        return core::framesOf(parts_.document.current().shown().followed);
    }

private:
    QString blockingReason() const;
    void start();
    void finishTracking(const std::vector<core::TrackedRunFrame>& frames);
    void updateFromDocument();
    void showFrame(int frame);
    void showMotion();
    void exportPoses();
    bool matchesStart(const core::Case& started, const core::TrackedRun& run) const;

    Parts parts_;
    TrackingJob job_;
    core::Case startedFrom_;
    std::shared_ptr<const std::vector<core::TrackedRunFrame>> shownPoses_;   ///< poses in plot and views; null: none
};

}   // namespace angiopose::app

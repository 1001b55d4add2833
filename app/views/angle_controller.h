#pragma once

#include "app/document/case_document.h"
#include "app/editing/branch_controller.h"
#include "app/jobs/job.h"
#include "core/viewing/angle_map.h"
#include "ui/dialogs/angle_dialog.h"

#include <QObject>
#include <QPointer>

#include <optional>

class QWidget;

namespace angiopose::ui {
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Determines the C-arm angles from which the selected branch is visible, for the pose of the shown view, and updates
/// them whenever the branch, pose or geometry changes.
class AngleController : public QObject {
    Q_OBJECT
public:
    AngleController(CaseDocument& document, BranchController& branches, ui::WindowActions& actions,
                    QWidget& dialogParent, QObject* parent = nullptr);

    bool isRunning() const { return job_.isRunning(); }
    void open();
    ui::AngleDialog* dialog() const { return dialog_; }   ///< null while the dialog is closed

private:
    /// Request for an angle map: the branch, the part of it to view, and the position of the vessels.
    struct MapRequest {
        int branchId = 0;
        core::ViewEvaluator sight;
        core::PoseAtAngles poseAt;
        core::GantryAngles now;
        core::ProjectionCamera camera;
    };
    core::Result<MapRequest> mapRequest() const;
    void requestMap();
    void show(const core::AngleMap& map);
    void pick(const core::GantryAngles& angles);
    void showReason(const QString& reason);

    CaseDocument& document_;
    BranchController& branches_;
    QWidget& dialogParent_;
    QPointer<ui::AngleDialog> dialog_;
    std::optional<MapRequest> requested_;
    Job<core::AngleMap> job_;
};

}   // namespace angiopose::app

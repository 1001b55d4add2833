#pragma once

#include "app/document/case_document.h"
#include "app/editing/angiogram_controller.h"
#include "app/editing/branch_controller.h"
#include "app/editing/branch_picking.h"
#include "app/editing/geometry_controller.h"
#include "app/editing/history_controller.h"
#include "app/editing/initial_pose_controller.h"
#include "app/editing/landmark_controller.h"
#include "app/editing/mark_controller.h"
#include "app/editing/mask_controller.h"
#include "app/editing/measure_controller.h"
#include "app/editing/path_controller.h"
#include "app/editing/pivot_controller.h"
#include "app/editing/pose_controller.h"
#include "app/editing/tracing_controller.h"
#include "app/editing/tree_actions.h"
#include "app/files/session_controller.h"
#include "app/files/title_controller.h"
#include "app/help/help_controller.h"
#include "app/help/support_controller.h"
#include "app/menus/user_preferences.h"
#include "app/registration/registration_controller.h"
#include "app/registration/target_provider.h"
#include "app/review/detector_drr_controller.h"
#include "app/review/drr_controller.h"
#include "app/review/evaluation_controller.h"
#include "app/review/movie_controller.h"
#include "app/review/overlay_style_controller.h"
#include "app/review/pose_gestures.h"
#include "app/review/pose_tools.h"
#include "app/review/profile_controller.h"
#include "app/review/replay_controller.h"
#include "app/review/scan_controller.h"
#include "app/review/slice_controller.h"
#include "app/review/step_layout_controller.h"
#include "app/review/tracking_controller.h"
#include "app/review/view_placement_controller.h"
#include "app/run_controller.h"
#include "app/showing/cine_controller.h"
#include "app/showing/notifications.h"
#include "app/showing/patient_controller.h"
#include "app/showing/pose_preview.h"
#include "app/showing/review_controller.h"
#include "app/showing/view_sync.h"
#include "app/step_controller.h"
#include "app/views/angle_controller.h"
#include "app/views/linked_crosshair.h"
#include "app/views/side_by_side_controller.h"
#include "app/views/view_controller.h"
#include "ui/main_window.h"

namespace angiopose::app {

/// Connects the window to the document and the jobs. Each sub-controller implements one user task and receives the
/// panels and views that it needs; this class connects the behavior of the whole window (pages, keys, closing).
class CaseController : public QObject {
    Q_OBJECT
public:
    explicit CaseController(ui::MainWindow& window, QObject* parent = nullptr);

    /// Shows the notice and the recovery offer, and opens the files given on the command line.
    void begin(const QStringList& paths);
    void open(const QStringList& paths) { session_.open(paths); }
    bool isLoading() const { return session_.isLoading(); }
    bool isBusy() const;   ///< true during a blind trial or while a long-running worker is active

    CaseDocument& document() { return document_; }
    SaveController& saveController() { return session_.saveController(); }
    ExportController& exportController() { return session_.exportController(); }
    RegistrationController& registration() { return registration_; }
    PoseController& pose() { return pose_; }
    BranchController& branches() { return branches_; }
    AngiogramController& angiogram() { return angiogram_; }
    TargetProvider& target() { return target_; }
    TracingController& tracing() { return tracing_; }
    MaskController& mask() { return mask_; }
    PoseTools& poses() { return poses_; }
    const PosePreview& preview() const { return preview_; }
    TrackingController& tracking() { return trackingController_; }
    const MovieController& movie() const { return movieController_; }
    UserPreferences& preferences() { return preferences_; }
    const ScanController& scan() const { return scan_; }
    const SharedEvaluation& evaluation() const { return evaluationController_.current(); }

private:
    void connectWindow();
    void connectNotes();
    void connectTracing();
    void connectReview();
    void updateFromDocument();
    void showPage();
    void updateFromTarget();

    ui::MainWindow& window_;
    Notifications notifications_;
    CaseDocument document_;
    TargetProvider target_;
    PosePreview preview_;
    ViewSync sync_;
    HistoryController history_;
    BranchController branches_;
    BranchPicker picking_;
    PoseController pose_;
    PivotController pivot_;
    LandmarkController landmarks_;
    MeasureController measureController_;
    MarkController marks_;
    InitialPoseController initialPose_;
    GeometryController geometry_;
    AngiogramController angiogram_;
    RegistrationController registration_;
    SessionController session_;
    ProfileController profile_;
    TitleController title_;
    PatientController patient_;
    ReviewController review_;
    CineController cine_;
    OverlayStyleController overlayStyle_;
    ReplayController replayController_;
    EvaluationController evaluationController_;
    PoseGestures gestures_;
    RunController runController_;
    SliceController slices_;
    TracingController tracing_;
    MaskController mask_;
    PathController paths_;
    TreeActions treeActions_;
    StepController steps_;
    PoseTools poses_;
    ViewPlacementController viewPlacement_;
    StepLayoutController layout_;
    ViewController views_;
    SideBySideController sideBySide_;
    LinkedCrosshair crosshair_;
    AngleController angles_;
    TrackingController trackingController_;
    MovieController movieController_;
    DrrController drr_;
    ScanController scan_;
    DetectorDrrController detectorDrr_;
    UserPreferences preferences_;
    HelpController help_;
    SupportController support_;
};

}   // namespace angiopose::app

#pragma once

#include "app/editing/auxiliary_controller.h"
#include "app/files/plot_export.h"
#include "app/files/session_controller.h"
#include "app/review/blind_trial_controller.h"
#include "app/review/evaluation_controller.h"
#include "app/review/pose_table_controller.h"
#include "app/review/replay_controller.h"
#include "app/review/snapshot_controller.h"
#include "app/review/solution_controller.h"
#include "app/showing/notifications.h"
#include "app/showing/review_controller.h"

#include <QObject>

class QWidget;

namespace angiopose::ui {
class AngiogramView;
class BottomStrip;
class LandmarkPanel;
class ResultPanel;
class SnapshotPanel;
class TrialBar;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Owns and connects the pose tools other than manual adjustment: solutions, snapshots, comparison, blind trials and
/// branch suggestions.
class PoseTools : public QObject {
    Q_OBJECT
public:
    /// Objects that the tools work with.
    struct Parts {
        CaseDocument& document;
        TargetProvider& target;
        BranchController& branches;
        SessionController& session;
        ReviewController& review;
        ReplayController& replay;
        EvaluationController& evaluation;
        PosePreview& preview;
        Notifications& notifications;
        ui::WindowActions& actions;
        ui::AngiogramView& view;
        ui::ResultPanel& result;
        ui::SnapshotPanel& snapshotPanel;
        ui::LandmarkPanel& landmarks;
        ui::TrialBar& trialBar;
        ui::BottomStrip& strip;
        QWidget& dialogParent;
    };
    explicit PoseTools(const Parts& parts, QObject* parent = nullptr);

    bool isBusy() const { return table_.isRunning() || auxiliary_.isRunning(); }
    SnapshotController& snapshots() { return snapshots_; }
    PoseTableController& table() { return table_; }
    BlindTrialController& blindTrial() { return blindTrial_; }
    AuxiliaryController& auxiliary() { return auxiliary_; }

private:
    void makeExclusive(const Parts& parts);
    void connectTrial(const Parts& parts);

    SolutionController solutions_;
    SnapshotController snapshots_;
    PoseTableController table_;
    BlindTrialController blindTrial_;
    AuxiliaryController auxiliary_;
    PlotExport plots_;
};

}   // namespace angiopose::app

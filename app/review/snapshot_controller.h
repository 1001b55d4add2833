#pragma once

#include "app/document/case_document.h"
#include "app/jobs/evaluation_job.h"
#include "app/showing/pose_preview.h"
#include "ui/panels/snapshot_panel.h"
#include "ui/words/retranslation.h"

#include <QObject>

#include <set>

namespace angiopose::ui {
class BottomStrip;
class SnapshotPanel;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Manages pose snapshots: saves, shows, restores, renames and deletes them, and toggles between two of them with one
/// key. Showing a snapshot does not change the case; the other actions are undo steps.
class SnapshotController : public QObject {
    Q_OBJECT
public:
    SnapshotController(CaseDocument& document, PosePreview& preview, ui::WindowActions& actions,
                       ui::SnapshotPanel& panel, ui::BottomStrip& strip, QObject* parent = nullptr);

    /// Sets the evaluation that provides the metrics of a new snapshot; null until it is available.
    void setEvaluation(const SharedEvaluation& evaluation);
    std::optional<core::SnapshotMetrics> metricsOfPose() const;   ///< nullopt until the evaluation is available

    void saveSnapshot();
    void show(int snapshotId);   ///< shows a snapshot; 0 is the current pose
    void showCurrentPose();
    void restore(int snapshotId);
    void rename(int snapshotId, const QString& name);
    void change(const core::PoseSnapshot& edited);   ///< changes name, author and note of the snapshot with the same ID
    void remove(const std::set<int>& snapshotIds);
    void mark(int snapshotId, bool isA);
    void toggleAB();   ///< toggles between the two marked poses: A, B, A, …
    const ui::SnapshotMarks& marks() const { return marks_; }

signals:
    void snapshotShown();   ///< emitted when a snapshot is shown, which should end other animations
    void poseEvaluated();

private:
    void connectWindow();
    void updateFromDocument();
    const core::PoseSnapshot* find(int snapshotId) const;
    void push(std::vector<core::PoseSnapshot> snapshots, const ui::LocalizedText& name);
    void showMarks();

    CaseDocument& document_;
    PosePreview& preview_;
    ui::WindowActions& actions_;
    ui::SnapshotPanel& panel_;
    ui::BottomStrip& strip_;
    SharedEvaluation evaluation_;
    ui::SnapshotMarks marks_;
    bool showsB_ = false;
    std::vector<std::string> shownRows_;   ///< rows of the panel, which is refilled only if they change
};

}   // namespace angiopose::app

#pragma once

#include "app/document/case_document.h"
#include "app/jobs/judge_job.h"
#include "app/showing/pose_preview.h"
#include "ui/panels/snapshot_panel.h"
#include "ui/words/spoken.h"

#include <QObject>

#include <set>

namespace angiopose::ui {
class BottomStrip;
class SnapshotPanel;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Poses as things: keep, look at, restore, rename, delete, and go between two with one key. Looking changes nothing;
/// the rest are steps of undo.
class SnapshotController : public QObject {
    Q_OBJECT
public:
    SnapshotController(CaseDocument& document, PosePreview& preview, ui::WindowActions& actions,
                       ui::SnapshotPanel& panel, ui::BottomStrip& strip, QObject* parent = nullptr);

    /// The numbers that a pose kept now gets; null while they are not known.
    void knowJudgement(const SharedJudgement& judgement);
    std::optional<core::SnapshotMetrics> metricsOfPose() const;   ///< nothing while they are not known

    void keep();
    void show(int snapshotId);   ///< 0: the pose as it is
    void showItself();
    void restore(int snapshotId);
    void rename(int snapshotId, const QString& name);
    void change(const core::PoseSnapshot& edited);   ///< name, author and note of the snapshot with its id
    void remove(const std::set<int>& snapshotIds);
    void mark(int snapshotId, bool isA);
    void switchSides();   ///< A, B, A, …
    const ui::SnapshotMarks& marks() const { return marks_; }

signals:
    void wasShown();   ///< whatever else moves should end
    void poseWasJudged();

private:
    void connectWindow();
    void followDocument();
    const core::PoseSnapshot* find(int snapshotId) const;
    void push(std::vector<core::PoseSnapshot> snapshots, const ui::Words& name);
    void showMarks();

    CaseDocument& document_;
    PosePreview& preview_;
    ui::WindowActions& actions_;
    ui::SnapshotPanel& panel_;
    ui::BottomStrip& strip_;
    SharedJudgement judgement_;
    ui::SnapshotMarks marks_;
    bool isOnB_ = false;
    std::vector<std::string> listed_;   ///< what the panel shows, to fill it only when that changed
};

}   // namespace angiopose::app
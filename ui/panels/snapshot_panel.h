#pragma once

#include "core/registration/pose_snapshot.h"
#include "ui/controls/section.h"

#include <optional>
#include <set>

class QHBoxLayout;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace angiopose::ui {

/// Snapshots between which the A/B key toggles, and the one on screen. If `a` has no value, it is the current pose.
struct SnapshotMarks {
    std::optional<int> a;
    std::optional<int> b;
    std::optional<int> shown;

    bool operator==(const SnapshotMarks&) const = default;
};

/// Panel with the list of snapshots and, in a collapsed group below, the registration results. Passive view: displays
/// the given state and emits signals for user actions.
class SnapshotPanel : public Section {
    Q_OBJECT
public:
    explicit SnapshotPanel(QWidget* parent = nullptr);

    void showSnapshots(const std::vector<core::PoseSnapshot>& snapshots);   ///< emits no signal, keeps the selection
    void showMarks(const SnapshotMarks& marks);
    void editName(int snapshotId);   ///< starts editing the name in its row
    QTreeWidget* list() const { return list_; }

signals:
    void snapshotRequested();
    void compareRequested();
    void snapshotPicked(int snapshotId);   ///< emitted with the snapshot to display; 0 is the current pose
    void restoreRequested(int snapshotId);
    void renamed(int snapshotId, const QString& name);
    void removeRequested(const std::set<int>& snapshotIds);
    void markRequested(int snapshotId, bool isA);   ///< marks the snapshot as A if `isA` is true, otherwise as B

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void setUpList();
    QHBoxLayout* makeButtons();
    void connectList();
    QTreeWidgetItem* itemOf(int snapshotId) const;
    std::set<int> selectedIds() const;
    void fillItem(QTreeWidgetItem& item, const core::PoseSnapshot& snapshot) const;
    void addRuns(const std::vector<core::PoseSnapshot>& snapshots);
    void showContextMenu(const QPoint& position);
    void fitHeight();
    void color();

    QTreeWidget* list_;
    QLabel* empty_;
    QPushButton* compare_;
    SnapshotMarks marks_;
    bool areRunsExpanded_ = false;
    bool isUpdating_ = false;   ///< true while the program, not the user, changes the list
};

}   // namespace angiopose::ui

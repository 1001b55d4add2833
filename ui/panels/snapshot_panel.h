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

/// Which snapshots the key for A and B goes between, and which one is on screen now. Nothing for `a` means the pose as
/// it is.
struct SnapshotMarks {
    std::optional<int> a;
    std::optional<int> b;
    std::optional<int> shown;

    bool operator==(const SnapshotMarks&) const = default;
};

/// The list of kept poses, and below it, folded, what the runs left. Shows what it is told, reports what the user
/// wants.
class SnapshotPanel : public Section {
    Q_OBJECT
public:
    explicit SnapshotPanel(QWidget* parent = nullptr);

    void showSnapshots(const std::vector<core::PoseSnapshot>& snapshots);   ///< silent, keeps the selection
    void showMarks(const SnapshotMarks& marks);
    void editName(int snapshotId);   ///< opens the editor in its row
    QTreeWidget* list() const { return list_; }

signals:
    void keepRequested();
    void compareRequested();
    void wasPicked(int snapshotId);   ///< to be looked at
    void restoreRequested(int snapshotId);
    void renamed(int snapshotId, const QString& name);
    void removeRequested(const std::set<int>& snapshotIds);
    void markRequested(int snapshotId, bool isA);   ///< as A, or else as B

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
    bool areRunsUnfolded_ = false;
    bool showing_ = false;   ///< true while the owner, not the user, changes the list
};

}   // namespace angiopose::ui

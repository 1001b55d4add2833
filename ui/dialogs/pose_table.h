#pragma once

#include "core/geometry/pose_difference.h"
#include "core/registration/pose_snapshot.h"

#include <QDialog>

#include <optional>
#include <set>
#include <string>
#include <vector>

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace angiopose::ui {

/// Row of the comparison: a snapshot, or the current pose (ID 0), with its difference from the reference.
struct PoseRow {
    core::PoseSnapshot snapshot;
    core::PoseDifference difference;
};

/// Table that compares poses, methods and observers. Non-modal passive view: displays the given state and emits
/// signals for user actions.
class PoseTable : public QDialog {
    Q_OBJECT
public:
    explicit PoseTable(QWidget* parent);

    void showRows(const std::vector<PoseRow>& rows, int referenceId);   ///< emits no signal
    void showChosenMethods(const std::vector<std::string>& methodIds);
    void showRun(const QString& what, double progress);   ///< shows the progress of the running registrations
    void showIdle(const QString& statusText);
    QTreeWidget* table() const { return table_; }

signals:
    void snapshotPicked(int snapshotId);   ///< emitted with the snapshot to display; 0 is the current pose
    void referenceRequested(int snapshotId);
    void restoreRequested(int snapshotId);
    void removeRequested(const std::set<int>& snapshotIds);
    void textEdited(const core::PoseSnapshot& edited);   ///< emitted when the user has edited name, author or note
    void runRequested(const std::vector<std::string>& methodIds);
    void stopRequested();
    void exportRequested();

private:
    QWidget* makeMethods();
    QLayout* makeButtons();
    void fillRow(QTreeWidgetItem& item, const PoseRow& row, bool isReference);
    void reportEdit(const QTreeWidgetItem& item, int column);
    std::set<int> selectedIds() const;
    std::vector<std::string> chosenMethods() const;
    void updateButtons();

    QTreeWidget* table_;
    QLabel* reference_;
    std::vector<QCheckBox*> methods_;
    QPushButton* run_;
    QPushButton* stop_;
    QProgressBar* progress_;
    QLabel* status_;
    QPushButton* restore_;
    QPushButton* makeReference_;
    QPushButton* remove_;
    std::vector<PoseRow> rows_;
    bool isUpdating_ = false;
    bool running_ = false;
};

}   // namespace angiopose::ui

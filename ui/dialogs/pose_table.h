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

/// One row of the comparison: a snapshot (or the pose as it is, id 0) and how far it lies from the reference.
struct PoseRow {
    core::PoseSnapshot snapshot;
    core::PoseDifference difference;
};

/// Poses, methods and observers side by side. Stays open beside the window; shows what it is told, reports what the
/// user wants.
class PoseTable : public QDialog {
    Q_OBJECT
public:
    explicit PoseTable(QWidget* parent);

    void showRows(const std::vector<PoseRow>& rows, int referenceId);   ///< silent
    void showChosenMethods(const std::vector<std::string>& methodIds);
    void showRun(const QString& what, double progress);   ///< while methods run
    void showIdle(const QString& words);
    QTreeWidget* table() const { return table_; }

signals:
    void wasPicked(int snapshotId);   ///< to be looked at; 0: the pose as it is
    void referenceRequested(int snapshotId);
    void restoreRequested(int snapshotId);
    void removeRequested(const std::set<int>& snapshotIds);
    void textEdited(const core::PoseSnapshot& edited);   ///< name, author or note
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
    QLabel* words_;
    QPushButton* restore_;
    QPushButton* makeReference_;
    QPushButton* remove_;
    std::vector<PoseRow> rows_;
    bool showing_ = false;
    bool running_ = false;
};

}   // namespace angiopose::ui
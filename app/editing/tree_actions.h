#pragma once

#include "app/editing/tracing_controller.h"
#include "app/editing/tree_controller.h"
#include "app/editing/tree_gap_finder.h"

class QWidget;

namespace angiopose::ui {
class BranchPanel;
class CornerViews;
class SliceModel;
class SlicesPage;
class TreeView;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Connects the tree edits to menus, keys, the branch list, and clicks in the 3-D view and the slices.
class TreeActions : public QObject {
    Q_OBJECT
public:
    /// Parts of the window that the class uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::BranchPanel& panel;
        ui::TreeView& treeView;
        ui::CornerViews& corner;
        ui::SliceModel& slices;
        ui::SlicesPage& slicesPage;
        QWidget& dialogParent;
    };
    TreeActions(CaseDocument& document, BranchController& branches, TracingController& tracing, const Ui& ui,
                QObject* parent = nullptr);

    TreeController& tree() { return tree_; }
    const TreeGapFinder& gapFinder() const { return gapFinder_; }

signals:
    void refused(const QString& reason);
    void gapsChanged();
    void pivotRequested(const Eigen::Vector3d& pointInPatient);   ///< emitted when a menu sets the rotation center

private:
    void connectCommands();
    void connectList();
    void connectViews();
    void enableCommands();
    void showAdvice();
    void goToGap();
    void bridgeGap();
    void openPruneDialog();
    void openBranchMenu(int branchId, const Eigen::Vector3d& pointInPatient, const QPoint& globalPosition);
    void openSliceMenu(const Eigen::Vector3d& pointInPatient, const QPoint& globalPosition);

    CaseDocument& document_;
    BranchController& branches_;
    TracingController& tracing_;
    Ui ui_;
    TreeController tree_;
    TreeGapFinder gapFinder_;
};

}   // namespace angiopose::app

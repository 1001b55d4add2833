#pragma once

#include "app/editing/branch_controller.h"
#include "app/showing/view_sync.h"

#include <QObject>

namespace angiopose::ui {
class AngiogramView;
class BranchPanel;
class TreeView;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Brings what the user points at, in the list, in the views or by command, to the branch controller, and its marks
/// back.
class BranchPicking : public QObject {
    Q_OBJECT
public:
    /// What of the window it serves.
    struct Ui {
        ui::WindowActions& actions;
        ui::BranchPanel& panel;
        ui::AngiogramView& view;
        ui::TreeView& treeView;
    };
    BranchPicking(const CaseDocument& document, BranchController& branches, ViewSync& sync, const Ui& ui,
                  QObject* parent = nullptr);

private:
    void connectList();
    void connectViews();
    void connectCommands();
    void makeAuxiliaryWhatIsInView();

    const CaseDocument& document_;
    BranchController& branches_;
    Ui ui_;
};

}   // namespace angiopose::app
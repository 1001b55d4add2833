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

/// Connects picking in the list, in the views and by command to the branch controller, and shows branch marks there.
class BranchPicker : public QObject {
    Q_OBJECT
public:
    /// Parts of the window that the class uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::BranchPanel& panel;
        ui::AngiogramView& view;
        ui::TreeView& treeView;
    };
    BranchPicker(const CaseDocument& document, BranchController& branches, ViewSync& sync, const Ui& ui,
                 QObject* parent = nullptr);

private:
    void connectList();
    void connectViews();
    void connectCommands();
    void setAuxiliaryInView();

    const CaseDocument& document_;
    BranchController& branches_;
    Ui ui_;
};

}   // namespace angiopose::app

#pragma once

#include "app/editing/branch_controller.h"
#include "app/showing/view_sync.h"

#include <QObject>

namespace angiopose::ui {
class MainWindow;
}

namespace angiopose::app {

/// Brings what the user points at, in the list, in the views or by command, to the branch controller, and its marks
/// back.
class BranchPicking : public QObject {
    Q_OBJECT
public:
    BranchPicking(const CaseDocument& document, BranchController& branches, ViewSync& sync, ui::MainWindow& window,
                  QObject* parent = nullptr);

private:
    void connectList();
    void connectViews();
    void connectCommands();
    void makeAuxiliaryWhatIsInView();

    const CaseDocument& document_;
    BranchController& branches_;
    ui::MainWindow& window_;
};

}   // namespace angiopose::app
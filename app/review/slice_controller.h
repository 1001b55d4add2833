#pragma once

#include "app/document/case_document.h"
#include "app/editing/branch_controller.h"

#include <QObject>

namespace angiopose::ui {
class CornerViews;
class SliceModel;
class SliceView;
class SlicesPage;
class TreeView;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Manages the slice views of the scan: which scan, tree and position they show, and where in the window they appear.
class SliceController : public QObject {
    Q_OBJECT
public:
    /// Parts of the main window that the controller uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::SliceModel& slices;
        ui::SlicesPage& slicesPage;
        ui::CornerViews& corner;
        ui::TreeView& treeView;
    };
    SliceController(CaseDocument& document, BranchController& branches, const Ui& ui, QObject* parent = nullptr);

signals:
    void largeChanged(
        bool large);   ///< emitted when enlarged slices (in place of the image or in a window) are shown or hidden

private:
    void connectView(ui::SliceView& view);
    void updateFromDocument();
    void updateFromBranches();
    void goToBranch(int branchId);
    void setLarge(bool large);

    CaseDocument& document_;
    BranchController& branches_;
    Ui ui_;
    std::set<int> lastSelection_;   ///< selection at the last update, to detect changes
    std::shared_ptr<const core::Volume> shownVolume_;
    std::shared_ptr<const core::Angiogram> shownAngiogram_;
    core::InputFile shownLabels_;   ///< label image from which the vessels were traced
};

}   // namespace angiopose::app

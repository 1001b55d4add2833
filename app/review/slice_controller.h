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

/// The slices of the scan: which scan, tree and place they show, and where in the window.
class SliceController : public QObject {
    Q_OBJECT
public:
    /// What of the window it serves.
    struct Ui {
        ui::WindowActions& actions;
        ui::SliceModel& slices;
        ui::SlicesPage& slicesPage;
        ui::CornerViews& corner;
        ui::TreeView& treeView;
    };
    SliceController(CaseDocument& document, BranchController& branches, const Ui& ui, QObject* parent = nullptr);

signals:
    void largeShown(bool large);   ///< in the image's place, or its window

private:
    void connectView(ui::SliceView& view);
    void followDocument();
    void followBranches();
    void goToBranch(int branchId);
    void setLarge(bool large);

    CaseDocument& document_;
    BranchController& branches_;
    Ui ui_;
    std::set<int> selected_;   ///< last seen, to notice a new one
    std::shared_ptr<const core::Volume> shownVolume_;
    std::shared_ptr<const core::Angiogram> shownAngiogram_;
    core::InputFile shownLabels_;   ///< the label image the vessels come from
};

}   // namespace angiopose::app
#pragma once

#include "app/document/case_document.h"
#include "app/editing/branch_controller.h"

#include <QObject>

namespace angiopose::ui {
class MainWindow;
class SliceView;
}   // namespace angiopose::ui
namespace angiopose::app {

/// The slices of the scan: which scan, tree and place they show, and where in the window.
class SliceController : public QObject {
    Q_OBJECT
public:
    SliceController(CaseDocument& document, BranchController& branches, ui::MainWindow& window,
                    QObject* parent = nullptr);

private:
    void connectView(ui::SliceView& view);
    void followDocument();
    void followBranches();
    void goToBranch(int branchId);
    void setLarge(bool large);

    CaseDocument& document_;
    BranchController& branches_;
    ui::MainWindow& window_;
    std::set<int> selected_;   ///< last seen, to notice a new one
    std::shared_ptr<const core::Volume> shownVolume_;
    core::InputFile shownLabels_;   ///< the label image the vessels come from
};

}   // namespace angiopose::app
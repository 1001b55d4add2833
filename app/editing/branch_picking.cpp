#include "app/editing/branch_picking.h"

#include "ui/actions/window_actions.h"
#include "ui/panels/branch_panel.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tree_view.h"

namespace angiopose::app {

BranchPicker::BranchPicker(const CaseDocument& document, BranchController& branches, ViewSync& sync, const Ui& ui,
                           QObject* parent)
    : QObject(parent), document_(document), branches_(branches), ui_(ui)
{
    connect(&branches, &BranchController::marksChanged, this, [&branches, &sync] { sync.showMarks(branches.marks()); });
    connectList();
    connectViews();
    connectCommands();
}

void BranchPicker::connectList()
{
    const ui::BranchPanel& panel = ui_.panel;
    connect(&panel, &ui::BranchPanel::hovered, &branches_, &BranchController::hover);
    connect(&panel, &ui::BranchPanel::selectionEdited, &branches_, &BranchController::select);
    connect(&panel, &ui::BranchPanel::auxiliaryToggled, &branches_, &BranchController::toggleAuxiliary);
    connect(&panel, &ui::BranchPanel::excludedToggled, &branches_, &BranchController::toggleExcluded);
    connect(&panel, &ui::BranchPanel::auxiliaryReplaced, &branches_, &BranchController::setAuxiliary);
    connect(&panel, &ui::BranchPanel::auxiliaryCleared, this, [this] { branches_.setAuxiliary({}); });
}

void BranchPicker::connectViews()
{
    const auto selectNone = [this] { branches_.select({}); };
    const ui::AngiogramView& image = ui_.view;
    connect(&image, &ui::AngiogramView::branchHovered, &branches_, &BranchController::hover);
    connect(&image, &ui::AngiogramView::branchClicked, &branches_, &BranchController::click);
    connect(&image, &ui::AngiogramView::backgroundClicked, this, selectNone);
    const ui::TreeView& tree = ui_.treeView;
    connect(&tree, &ui::TreeView::branchHovered, &branches_, &BranchController::hover);
    connect(&tree, &ui::TreeView::branchClicked, &branches_, &BranchController::click);
    connect(&tree, &ui::TreeView::backgroundClicked, this, selectNone);
}

void BranchPicker::connectCommands()
{
    const ui::WindowActions& actions = ui_.actions;
    connect(actions[ui::Command::ToggleAuxiliary], &QAction::triggered, this,
            [this] { branches_.toggleAuxiliary(branches_.marks().selected); });
    connect(actions[ui::Command::ToggleExcluded], &QAction::triggered, this,
            [this] { branches_.toggleExcluded(branches_.marks().selected); });
    connect(actions[ui::Command::AuxiliaryLargeVessels], &QAction::triggered, &branches_,
            &BranchController::setAuxiliaryByRadius);
    connect(actions[ui::Command::AuxiliaryInView], &QAction::triggered, this, &BranchPicker::setAuxiliaryInView);
    connect(actions[ui::Command::SelectAll], &QAction::triggered, &branches_, &BranchController::selectAll);
}

void BranchPicker::setAuxiliaryInView()
{
    std::map<int, ui::ViewRect> extents;
    if (const auto& tree = document_.current().vessels.tree) {
        for (const core::VesselBranch& branch : tree->branches) {
            if (const auto extent = ui_.view.scene().extentOf(branch.id)) {
                extents[branch.id] = *extent;
            }
        }
    }
    branches_.setAuxiliaryInside(extents, ui_.view.visiblePart());
}

}   // namespace angiopose::app

#include "app/editing/pivot_controller.h"

#include "app/document/edit_case.h"
#include "core/vessel/tree_position.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/pose_panel.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tools/bind_tool.h"
#include "ui/views/tree_view.h"

namespace angiopose::app {

PivotController::PivotController(CaseDocument& document, const Ui& ui, QObject* parent)
    : QObject(parent), document_(document), ui_(ui), tool_(new ui::PivotTool(ui_.view))
{
    ui::bindTool(*ui_.actions[ui::Command::PickPivot], ui_.view, *tool_);
    connect(tool_, &ui::PivotTool::picked, this, &PivotController::pick);
    connect(tool_, &ui::PivotTool::centroidRequested, this, &PivotController::resetToCentroid);
    connect(ui_.actions[ui::Command::CentroidPivot], &QAction::triggered, this, &PivotController::resetToCentroid);
    connect(&document, &CaseDocument::changed, this, &PivotController::updateFromDocument);
    updateFromDocument();
}

void PivotController::pick(const Eigen::Vector3d& pointInPatient)
{
    const auto& tree = document_.current().vessels.tree;
    const auto place =
        tree ? core::nearestPointOnTree(core::withoutBranches(*tree, document_.current().vessels.hiddenBranchIds),
                                        pointInPatient)
             : std::nullopt;
    if (place) {
        change(
            *place, [] { return tr("Set rotation center"); }, tr("The vessels now rotate about the selected point."));
    }
}

void PivotController::pickIfActive(const Eigen::Vector3d& pointInPatient)
{
    if (ui_.actions[ui::Command::PickPivot]->isChecked()) {
        pick(pointInPatient);
    }
}

void PivotController::resetToCentroid()
{
    if (document_.current().vessels.pickedPivotInPatient) {
        change(
            std::nullopt, [] { return tr("Reset rotation center"); },
            tr("The vessels rotate about their centroid again."));
    }
}

void PivotController::change(const std::optional<Eigen::Vector3d>& pivot, const ui::LocalizedText& name,
                             const QString& note)
{
    if (document_.push(std::make_unique<PickPivot>(document_, PickPivot::Values{pivot}, name))) {
        ui_.actions[ui::Command::PickPivot]->setChecked(false);
        emit reported(note);
    }
}

void PivotController::updateFromDocument()
{
    const core::Case& current = document_.current();
    if (current.vessels.tree != tree_ || current.vessels.hiddenBranchIds != hidden_) {
        tree_ = current.vessels.tree;
        hidden_ = current.vessels.hiddenBranchIds;
        tool_->showTree(tree_ ? core::withoutBranches(*tree_, hidden_) : core::VesselTree{});
    }
    const auto& picked = tree_ ? current.vessels.pickedPivotInPatient : std::nullopt;
    ui_.view.setPickedPivot(picked);
    ui_.treeView.setPickedPivot(picked);
    ui_.panel.showPickedPivot(picked.has_value());
    ui_.actions[ui::Command::PickPivot]->setEnabled(tree_ != nullptr);
    ui_.actions[ui::Command::CentroidPivot]->setEnabled(picked.has_value());
}

}   // namespace angiopose::app

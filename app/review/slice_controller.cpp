#include "app/review/slice_controller.h"

#include "app/preferences/settings.h"
#include "ui/actions/window_actions.h"
#include "ui/slices/corner_views.h"
#include "ui/slices/slice_model.h"
#include "ui/slices/slices_page.h"
#include "ui/views/tree_view.h"

namespace angiopose::app {
namespace {

std::optional<core::BodyPlane> planeOf(int setting)
{
    const auto index = static_cast<std::size_t>(setting) - 1;
    return index < core::bodyPlanes.size() ? std::optional(core::bodyPlanes[index]) : std::nullopt;
}

int settingOf(std::optional<core::BodyPlane> plane)
{
    return plane ? static_cast<int>(*plane) + 1 : 0;
}

}   // namespace

SliceController::SliceController(CaseDocument& document, BranchController& branches, const Ui& ui, QObject* parent)
    : QObject(parent), document_(document), branches_(branches), ui_(ui)
{
    connectView(ui_.corner.slice());
    for (const core::BodyPlane plane : core::bodyPlanes) {
        connectView(ui_.slicesPage.view(plane));
    }
    connect(&document, &CaseDocument::changed, this, &SliceController::updateFromDocument);
    connect(&branches, &BranchController::marksChanged, this, &SliceController::updateFromBranches);
    connect(&ui_.treeView, &ui::TreeView::pointPicked, &ui_.slices, &ui::SliceModel::setCrosshair);
    const auto showInTree = [this] {
        const ui::SliceModel& slices = ui_.slices;
        ui_.treeView.setCrosshair(slices.hasScan() ? std::optional(slices.crosshair()) : std::nullopt);
    };
    connect(&ui_.slices, &ui::SliceModel::crosshairChanged, this, showInTree);
    connect(&ui_.slices, &ui::SliceModel::scanChanged, this, showInTree);

    ui::WindowActions& actions = ui_.actions;
    connect(actions[ui::Command::SlicesLarge], &QAction::toggled, this, &SliceController::setLarge);
    connect(actions[ui::Command::NextCornerView], &QAction::triggered, &ui_.corner, &ui::CornerViews::showNext);
    connect(&ui_.corner, &ui::CornerViews::enlargeRequested, actions[ui::Command::SlicesLarge], &QAction::toggle);
    connect(&ui_.slicesPage, &ui::SlicesPage::closeRequested, actions[ui::Command::SlicesLarge],
            [action = actions[ui::Command::SlicesLarge]] { action->setChecked(false); });
    ui_.corner.showPlane(planeOf(settings::cornerView.read()));
    connect(&ui_.corner, &ui::CornerViews::planeChanged, this,
            [](std::optional<core::BodyPlane> plane) { settings::cornerView.write(settingOf(plane)); });
    updateFromDocument();
}

void SliceController::connectView(ui::SliceView& view)
{
    connect(&view, &ui::SliceView::branchHovered, &branches_, &BranchController::hover);
    connect(&view, &ui::SliceView::branchClicked, &branches_, &BranchController::click);
}

void SliceController::setLarge(bool large)
{
    const bool isPossible = ui_.slices.hasScan();
    if (large && !isPossible) {
        ui_.actions[ui::Command::SlicesLarge]->setChecked(false);
        return;
    }
    emit largeChanged(large);
}

void SliceController::updateFromDocument()
{
    const core::Case& current = document_.current();
    const bool isNew = current.vessels.scan != shownVolume_;
    shownVolume_ = current.vessels.scan;
    const bool isNewImage = current.shown().angiogram && current.shown().angiogram != shownAngiogram_;
    shownAngiogram_ = current.shown().angiogram;
    const bool hasLabels = current.vessels.input.kind == core::VesselInputKind::Segmentation;
    const core::InputFile labels = hasLabels ? current.vessels.file : core::InputFile();
    const bool isNewLabels = labels != shownLabels_ && hasLabels;
    shownLabels_ = labels;
    ui_.slices.setTree(current.vessels.tree);
    ui_.slices.setScan(current.vessels.scan, current.vessels.lumen);
    const bool hasScan = ui_.slices.hasScan();
    ui_.actions[ui::Command::SlicesLarge]->setEnabled(hasScan);
    ui_.actions[ui::Command::NextCornerView]->setEnabled(hasScan);
    if (!hasScan) {
        ui_.actions[ui::Command::SlicesLarge]->setChecked(false);
    } else if ((isNew && current.vessels.scan) || isNewLabels) {
        if (current.vessels.tree && !current.vessels.tree->branches.empty()) {
            goToBranch(current.vessels.tree->branches.front().id);
        }
        if (!current.shown().angiogram) {   // without an angiogram, the slices are the main content
            ui_.actions[ui::Command::SlicesLarge]->setChecked(true);
        }
    }
    if (isNewImage) {   // a newly opened image takes the place of the enlarged slices
        ui_.actions[ui::Command::SlicesLarge]->setChecked(false);
    }
}

void SliceController::updateFromBranches()
{
    const std::set<int> selected = branches_.marks().selected;
    if (selected != lastSelection_ && selected.size() == 1) {
        goToBranch(*selected.begin());
    }
    lastSelection_ = selected;
}

/// Moves the crosshair to the middle of a branch unless it is already on the branch.
void SliceController::goToBranch(int branchId)
{
    const auto& tree = document_.current().vessels.tree;
    const core::VesselBranch* branch = tree ? tree->find(branchId) : nullptr;
    if (!branch) {
        return;
    }
    constexpr double nearMm = 3.0;
    const Eigen::Vector3d& now = ui_.slices.crosshair();
    for (const Eigen::Vector3d& point : branch->pointsInPatient) {
        if ((point - now).norm() < nearMm) {
            return;
        }
    }
    ui_.slices.setCrosshair(branch->pointsInPatient[branch->pointsInPatient.size() / 2]);
}

}   // namespace angiopose::app

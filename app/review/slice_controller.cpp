#include "app/review/slice_controller.h"

#include "app/preferences/settings.h"
#include "ui/main_window.h"
#include "ui/slices/corner_views.h"
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

SliceController::SliceController(CaseDocument& document, BranchController& branches, ui::MainWindow& window,
                                 QObject* parent)
    : QObject(parent), document_(document), branches_(branches), window_(window)
{
    connectView(window.corner().slice());
    for (const core::BodyPlane plane : core::bodyPlanes) {
        connectView(window.slicesPage().view(plane));
    }
    connect(&document, &CaseDocument::changed, this, &SliceController::followDocument);
    connect(&branches, &BranchController::marksChanged, this, &SliceController::followBranches);
    connect(&window.treeView(), &ui::TreeView::pointPicked, &window.slices(), &ui::SliceModel::setCrosshair);
    const auto showInTree = [this] {
        const ui::SliceModel& slices = window_.slices();
        window_.treeView().setCrosshair(slices.hasScan() ? std::optional(slices.crosshair()) : std::nullopt);
    };
    connect(&window.slices(), &ui::SliceModel::crosshairChanged, this, showInTree);
    connect(&window.slices(), &ui::SliceModel::scanChanged, this, showInTree);

    ui::WindowActions& actions = window.actions();
    connect(actions[ui::Command::SlicesLarge], &QAction::toggled, this, &SliceController::setLarge);
    connect(actions[ui::Command::NextCornerView], &QAction::triggered, &window.corner(), &ui::CornerViews::showNext);
    connect(&window.corner(), &ui::CornerViews::roomRequested, actions[ui::Command::SlicesLarge], &QAction::toggle);
    connect(&window.slicesPage(), &ui::SlicesPage::closeRequested, actions[ui::Command::SlicesLarge],
            [action = actions[ui::Command::SlicesLarge]] { action->setChecked(false); });
    window.corner().showPlane(planeOf(settings::cornerView.read()));
    connect(&window.corner(), &ui::CornerViews::planeChanged, this,
            [](std::optional<core::BodyPlane> plane) { settings::cornerView.write(settingOf(plane)); });
    followDocument();
}

void SliceController::connectView(ui::SliceView& view)
{
    connect(&view, &ui::SliceView::branchHovered, &branches_, &BranchController::hover);
    connect(&view, &ui::SliceView::branchClicked, &branches_, &BranchController::click);
}

void SliceController::setLarge(bool large)
{
    const bool isPossible = window_.slices().hasScan();
    if (large && !isPossible) {
        window_.actions()[ui::Command::SlicesLarge]->setChecked(false);
        return;
    }
    window_.setSlicesLarge(large);
}

void SliceController::followDocument()
{
    const core::Case& current = document_.current();
    const bool isNew = current.vessels.scan != shownVolume_;
    shownVolume_ = current.vessels.scan;
    const bool hasLabels = current.vessels.input.kind == core::VesselInputKind::Segmentation;
    const core::InputFile labels = hasLabels ? current.vessels.file : core::InputFile();
    const bool isNewLabels = labels != shownLabels_ && hasLabels;
    shownLabels_ = labels;
    window_.slices().setTree(current.vessels.tree);
    window_.slices().setScan(current.vessels.scan, current.vessels.lumen);
    const bool hasScan = window_.slices().hasScan();
    window_.actions()[ui::Command::SlicesLarge]->setEnabled(hasScan);
    window_.actions()[ui::Command::NextCornerView]->setEnabled(hasScan);
    if (!hasScan) {
        window_.actions()[ui::Command::SlicesLarge]->setChecked(false);
    } else if ((isNew && current.vessels.scan) || isNewLabels) {
        if (current.vessels.tree && !current.vessels.tree->branches.empty()) {
            goToBranch(current.vessels.tree->branches.front().id);
        }
        if (!current.shown().angiogram) {   // nothing else to look at yet
            window_.actions()[ui::Command::SlicesLarge]->setChecked(true);
        }
    }
}

void SliceController::followBranches()
{
    const std::set<int> selected = branches_.marks().selected;
    if (selected != selected_ && selected.size() == 1) {
        goToBranch(*selected.begin());
    }
    selected_ = selected;
}

/// To the middle of a branch, unless the cross-hair is on it already.
void SliceController::goToBranch(int branchId)
{
    const auto& tree = document_.current().vessels.tree;
    const core::VesselBranch* branch = tree ? tree->find(branchId) : nullptr;
    if (!branch) {
        return;
    }
    constexpr double nearMm = 3.0;
    const Eigen::Vector3d& now = window_.slices().crosshair();
    for (const Eigen::Vector3d& point : branch->pointsInPatient) {
        if ((point - now).norm() < nearMm) {
            return;
        }
    }
    window_.slices().setCrosshair(branch->pointsInPatient[branch->pointsInPatient.size() / 2]);
}

}   // namespace angiopose::app
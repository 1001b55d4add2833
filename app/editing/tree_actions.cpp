#include "app/editing/tree_actions.h"

#include "core/vessel/edit_tree.h"
#include "ui/actions/window_actions.h"
#include "ui/dialogs/prune_dialog.h"
#include "ui/panels/branch_panel.h"
#include "ui/panels/result_sentences.h"
#include "ui/slices/corner_views.h"
#include "ui/slices/slice_model.h"
#include "ui/slices/slices_page.h"
#include "ui/views/tree_view.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <QCoreApplication>
#include <QMenu>

#include <array>
#include <optional>

namespace angiopose::app {
namespace {

using ui::Command;

/// Commands that change single branches, in menu order.
constexpr std::array branchCommands{Command::RenameBranch,   Command::CutBranch,     Command::JoinBranches,
                                    Command::SmoothBranches, Command::RootAtBranch,  Command::HideBranches,
                                    Command::DeleteBranches, Command::DeleteSubtrees};

int countPruned(const core::VesselTree& tree, const ui::PruneLimits& limits)
{
    const auto left = core::pruneTree(tree, limits.minLengthMm, limits.minRadiusMm);
    return left ? static_cast<int>(tree.branches.size() - left.value().branches.size()) : -1;
}

/// Returns the branch nearest to a point in a slice; nullopt if none is close enough.
std::optional<int> branchNear(const core::VesselTree& tree, const Eigen::Vector3d& point)
{
    double nearestMm = 3.0;
    std::optional<int> nearest;
    for (const core::VesselBranch& branch : tree.branches) {
        const std::size_t at = core::nearestPoint(tree, branch.id, point);
        const double distanceMm = (branch.pointsInPatient[at] - point).norm();
        if (distanceMm < nearestMm) {
            nearestMm = distanceMm;
            nearest = branch.id;
        }
    }
    return nearest;
}

void openMenu(QMenu* menu, const QPoint& globalPosition)
{
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->popup(globalPosition);
}

}   // namespace

TreeActions::TreeActions(CaseDocument& document, BranchController& branches, TracingController& tracing, const Ui& ui,
                         QObject* parent)
    : QObject(parent),
      document_(document),
      branches_(branches),
      tracing_(tracing),
      ui_(ui),
      tree_(document, branches),
      gapFinder_(document)
{
    connectCommands();
    connectList();
    connectViews();
    connect(&tree_, &TreeController::refused, this, &TreeActions::refused);
    connect(&gapFinder_, &TreeGapFinder::changed, this, &TreeActions::showAdvice);
    connect(&document, &CaseDocument::changed, this, &TreeActions::enableCommands);
    enableCommands();
    ui::keepTranslated(this, [this] { showAdvice(); });
}

void TreeActions::connectCommands()
{
    const auto on = [this](Command command, auto act) {
        connect(ui_.actions[command], &QAction::triggered, this, act);
    };
    on(Command::DeleteBranches, [this] { tree_.deleteSelected(); });
    on(Command::DeleteSubtrees, [this] { tree_.deleteSelectedSubtrees(); });
    on(Command::CutBranch, [this] { tree_.cutSelected(); });
    on(Command::JoinBranches, [this] { tree_.joinSelected(); });
    on(Command::SmoothBranches, [this] { tree_.smoothSelected(); });
    on(Command::RootAtBranch, [this] { tree_.rootAtSelected(); });
    on(Command::HideBranches, [this] { tree_.toggleHiddenSelected(); });
    on(Command::ShowAllBranches, [this] { tree_.showAll(); });
    on(Command::PruneTree, [this] { openPruneDialog(); });
    on(Command::BridgeGap, [this] { bridgeGap(); });
    on(Command::FindBranch, [this] { ui_.panel.focusFilter(); });
    on(Command::RenameBranch, [this] {
        const std::set<int>& selected = branches_.marks().selected;
        if (selected.size() == 1) {
            ui_.panel.editName(*selected.begin());
        } else {
            emit refused(tr("Select one branch: click it in the list or in a view."));
        }
    });
}

void TreeActions::connectList()
{
    ui::BranchPanel& panel = ui_.panel;
    QList<QAction*> actions;
    for (const Command command : branchCommands) {
        actions << ui_.actions[command];
    }
    panel.setEditActions(actions);
    connect(&panel, &ui::BranchPanel::renamed, &tree_, &TreeController::rename);
    connect(&panel, &ui::BranchPanel::generationChosen, &tree_, &TreeController::setGeneration);
    connect(&panel, &ui::BranchPanel::repairRequested, this, &TreeActions::bridgeGap);
    connect(&panel, &ui::BranchPanel::adviceShown, this, &TreeActions::goToGap);
}

void TreeActions::connectViews()
{
    connect(&ui_.slices, &ui::SliceModel::crosshairChanged, this,
            [this] { tree_.setClickedPoint(ui_.slices.crosshair()); });
    connect(&ui_.treeView, &ui::TreeView::branchMenuRequested, this, &TreeActions::openBranchMenu);
    std::vector<ui::SliceView*> views{&ui_.corner.slice()};
    for (const core::BodyPlane plane : core::bodyPlanes) {
        views.push_back(&ui_.slicesPage.view(plane));
    }
    for (ui::SliceView* view : views) {
        connect(view, &ui::SliceView::menuRequested, this, &TreeActions::openSliceMenu);
    }
}

void TreeActions::enableCommands()
{
    const bool hasTree = document_.current().vessels.tree != nullptr;
    for (const Command command : branchCommands) {
        ui_.actions[command]->setEnabled(hasTree);
    }
    ui_.actions[Command::PruneTree]->setEnabled(hasTree);
    ui_.actions[Command::FindBranch]->setEnabled(hasTree);
    ui_.actions[Command::ShowAllBranches]->setEnabled(!document_.current().vessels.hiddenBranchIds.empty());
}

void TreeActions::openPruneDialog()
{
    const auto tree = document_.current().vessels.tree;
    if (!tree) {
        return;
    }
    auto* dialog = new ui::PruneDialog([tree](const ui::PruneLimits& limits) { return countPruned(*tree, limits); },
                                       &ui_.dialogParent);
    connect(dialog, &ui::PruneDialog::pruneRequested, this,
            [this](const ui::PruneLimits& limits) { tree_.prune(limits.minLengthMm, limits.minRadiusMm); });
    dialog->open();
}

void TreeActions::showAdvice()
{
    const auto& tree = document_.current().vessels.tree;
    const bool isBroken = tree && gapFinder_.pieceCount() > 1;
    const bool isRepairable = isBroken && !gapFinder_.gaps().empty();
    ui_.actions[Command::BridgeGap]->setEnabled(isRepairable);
    QString text;
    if (isRepairable) {
        const core::TreeGap& gap = gapFinder_.gaps().front();
        const auto nameOf = [&tree](int id) {
            return ui::displayName(*tree->find(id))
                .replace(QLatin1Char(' '), QChar::Nbsp);   // prevents a line break within the name
        };
        text = tr("%1 components · gap %2 mm: %3 – %4")
                   .arg(gapFinder_.pieceCount())
                   .arg(ui::numberText(gap.distanceMm, 1))
                   .arg(nameOf(gap.fromBranchId), nameOf(gap.toBranchId));
    } else if (isBroken) {
        text = tr("%1 components, too far apart to join").arg(gapFinder_.pieceCount());
    }
    ui_.panel.showAdvice(text, isRepairable);
    emit gapsChanged();
}

void TreeActions::goToGap()
{
    if (!gapFinder_.gaps().empty()) {
        const core::TreeGap& gap = gapFinder_.gaps().front();
        branches_.select({gap.fromBranchId, gap.toBranchId});
        ui_.slices.setCrosshair(0.5 * (gap.fromInPatient + gap.toInPatient));
    }
}

void TreeActions::bridgeGap()
{
    if (!gapFinder_.gaps().empty() && !gapFinder_.isSearching()) {
        tree_.bridge(gapFinder_.gaps().front());
    }
}

void TreeActions::openBranchMenu(int branchId, const Eigen::Vector3d& pointInPatient, const QPoint& globalPosition)
{
    if (!branches_.marks().selected.contains(branchId)) {
        branches_.select({branchId});
    }
    ui_.slices.setCrosshair(pointInPatient);
    tree_.setClickedPoint(pointInPatient);
    auto* menu = new QMenu(&ui_.dialogParent);
    menu->addAction(ui_.actions[Command::ToggleAuxiliary]);
    menu->addAction(ui_.actions[Command::ToggleExcluded]);
    menu->addAction(tr("Rotate vessels about this point"), this,
                    [this, pointInPatient] { emit pivotRequested(pointInPatient); });
    menu->addAction(ui_.actions[Command::GantryAngles]);
    menu->addSeparator();
    for (const Command command : branchCommands) {
        menu->addAction(ui_.actions[command]);
    }
    openMenu(menu, globalPosition);
}

void TreeActions::openSliceMenu(const Eigen::Vector3d& pointInPatient, const QPoint& globalPosition)
{
    ui_.slices.setCrosshair(pointInPatient);
    const auto& tree = document_.current().vessels.tree;
    const auto branch = tree ? branchNear(*tree, pointInPatient) : std::nullopt;
    if (branch && !branches_.marks().selected.contains(*branch)) {
        branches_.select({*branch});
    }
    auto* menu = new QMenu(&ui_.dialogParent);
    if (ui_.actions[Command::TraceScan]->isEnabled()) {
        menu->addAction(tr("Place seed here"), this,
                        [this, pointInPatient] { tracing_.addPoint(ui::TracingPick::Seed, pointInPatient); });
        menu->addAction(tr("Avoid this point"), this,
                        [this, pointInPatient] { tracing_.addPoint(ui::TracingPick::Avoid, pointInPatient); });
        menu->addSeparator();
    }
    for (const ui::WindowPreset& preset : ui::windowPresets()) {
        menu->addAction(QCoreApplication::translate("angiopose::ui::WindowPreset", preset.name), this,
                        [this, window = preset.window] { ui_.slices.setWindow(window); });
    }
    if (branch) {
        menu->addSeparator();
        for (const Command command : branchCommands) {
            menu->addAction(ui_.actions[command]);
        }
    }
    menu->addSeparator();
    menu->addAction(ui_.actions[Command::SlicesLarge]);
    openMenu(menu, globalPosition);
}

}   // namespace angiopose::app

#include "app/habits/menu_controller.h"

#include "app/editing/branch_controller.h"
#include "ui/actions/window_actions.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tree_view.h"

#include <QMenu>

#include <initializer_list>

namespace angiopose::app {
namespace {

using enum ui::Command;

void addCommands(QMenu* menu, const ui::WindowActions& actions, std::initializer_list<ui::Command> commands)
{
    for (const ui::Command command : commands) {
        menu->addAction(actions[command]);
    }
    menu->addSeparator();
}

}   // namespace

MenuController::MenuController(BranchController& branches, ui::WindowActions& actions, ui::AngiogramView& view,
                               ui::TreeView& treeView, QWidget& menuParent, QObject* parent)
    : QObject(parent), branches_(branches), actions_(actions), menuParent_(menuParent)
{
    connect(&view, &ui::AngiogramView::menuRequested, this, &MenuController::showAngiogramMenu);
    connect(&treeView, &ui::TreeView::menuRequested, this, &MenuController::showTreeMenu);
}

/// Begins with what can be done with the branch under the mouse, which is selected then.
QMenu* MenuController::makeMenu(std::optional<int> branchId)
{
    auto* menu = new QMenu(&menuParent_);
    menu->setObjectName(QStringLiteral("contextMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (!branchId) {
        return menu;
    }
    if (!branches_.marks().selected.contains(*branchId)) {
        branches_.select({*branchId});
    }
    addCommands(menu, actions_, {ToggleAuxiliary, ToggleExcluded});
    return menu;
}

void MenuController::showAngiogramMenu(const QPoint& globalPosition, std::optional<int> branchId)
{
    QMenu* menu = makeMenu(branchId);
    addCommands(menu, actions_, {Nudge, PickPivot, CentroidPivot, ResetPose, Register});
    addCommands(menu, actions_, {Fit, WorstBranch, AutoWindow, Invert});
    addCommands(menu, actions_, {Outline, Swipe, Flicker, ShowTrace});
    addCommands(menu, actions_, {ExportOverlay, CopyWindow});
    menu->popup(globalPosition);
}

void MenuController::showTreeMenu(const QPoint& globalPosition, std::optional<int> branchId)
{
    QMenu* menu = makeMenu(branchId);
    addCommands(menu, actions_, {SelectAll, AuxiliaryInView, AuxiliaryWide});
    addCommands(menu, actions_, {ResetTreeView, CopyWindow});
    menu->popup(globalPosition);
}

}   // namespace angiopose::app
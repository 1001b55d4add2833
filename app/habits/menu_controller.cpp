#include "app/habits/menu_controller.h"

#include "app/editing/branch_controller.h"
#include "ui/main_window.h"
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

MenuController::MenuController(BranchController& branches, ui::MainWindow& window, QObject* parent)
    : QObject(parent), branches_(branches), window_(window)
{
    connect(&window.angiogramView(), &ui::AngiogramView::menuRequested, this, &MenuController::showAngiogramMenu);
    connect(&window.treeView(), &ui::TreeView::menuRequested, this, &MenuController::showTreeMenu);
}

/// Begins with what can be done with the branch under the mouse, which is selected then.
QMenu* MenuController::makeMenu(std::optional<int> branchId)
{
    auto* menu = new QMenu(&window_);
    menu->setObjectName(QStringLiteral("contextMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (!branchId) {
        return menu;
    }
    if (!branches_.marks().selected.contains(*branchId)) {
        branches_.select({*branchId});
    }
    addCommands(menu, window_.actions(), {ToggleAuxiliary, ToggleExcluded});
    return menu;
}

void MenuController::showAngiogramMenu(const QPoint& globalPosition, std::optional<int> branchId)
{
    QMenu* menu = makeMenu(branchId);
    addCommands(menu, window_.actions(), {Nudge, PickPivot, CentroidPivot, ResetPose, Register});
    addCommands(menu, window_.actions(), {Fit, WorstBranch, AutoWindow, Invert});
    addCommands(menu, window_.actions(), {Outline, Swipe, Flicker, ShowTrace});
    addCommands(menu, window_.actions(), {ExportOverlay, CopyWindow});
    menu->popup(globalPosition);
}

void MenuController::showTreeMenu(const QPoint& globalPosition, std::optional<int> branchId)
{
    QMenu* menu = makeMenu(branchId);
    addCommands(menu, window_.actions(), {SelectAll, AuxiliaryInView, AuxiliaryWide});
    addCommands(menu, window_.actions(), {ResetTreeView, CopyWindow});
    menu->popup(globalPosition);
}

}   // namespace angiopose::app
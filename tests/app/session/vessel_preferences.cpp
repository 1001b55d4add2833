#include "tests/app/session/tool_preference.h"
#include "ui/slices/slice_view.h"
#include "ui/views/tree_view.h"

#include <QListView>
#include <QTest>

#include <array>

namespace angiopose::test {
namespace {

QString workInTreeView(Desk& desk)
{
    ui::TreeView& view = desk.window.treeView();
    if (!view.isVisible()) {
        return {};
    }
    const int choice = desk.hand.below(4);
    if (choice == 0) {
        desk.hand.drag(view, Qt::LeftButton);
    } else if (choice == 1) {
        desk.hand.drag(view, Qt::RightButton);
    } else if (choice == 2) {
        desk.hand.askForMenu(view);
    } else {
        desk.hand.click(view);
    }
    return QStringLiteral("3-D view");
}

QString workInSlices(Desk& desk)
{
    const auto views = usable<ui::SliceView>(desk.window);
    if (views.empty()) {
        return {};
    }
    static constexpr std::array keys{Qt::Key_Up, Qt::Key_PageDown, Qt::Key_Home, Qt::Key_Return};
    static constexpr std::array buttons{Qt::LeftButton, Qt::MiddleButton, Qt::RightButton};
    ui::SliceView& view = *desk.hand.oneOf(views);
    const int choice = desk.hand.below(5);
    if (choice == 0) {
        QTest::keyClick(&view, desk.hand.oneOf(keys));
    } else if (choice == 1) {
        desk.hand.click(view, desk.hand.oneOf(buttons));
    } else if (choice == 2) {
        desk.hand.wheel(view);
    } else if (choice == 3) {
        desk.hand.askForMenu(view);
    } else {
        desk.hand.drag(view, desk.hand.oneOf(buttons));
    }
    return QStringLiteral("slices");
}

QString editTree(Desk& desk)
{
    static constexpr std::array edits{
        ui::Command::CutBranch,    ui::Command::JoinBranches,    ui::Command::SmoothBranches, ui::Command::RootAtBranch,
        ui::Command::HideBranches, ui::Command::ShowAllBranches, ui::Command::DeleteBranches, ui::Command::Undo};
    QAction* edit = desk.window.actions()[desk.hand.oneOf(edits)];
    edit->trigger();
    return QStringLiteral("tree: ") + edit->objectName();
}

QString clickBranch(Desk& desk)
{
    QListView& list = *desk.window.branches().list();
    if (!list.isVisible()) {
        return {};
    }
    QWidget& port = *list.viewport();
    if (desk.hand.oneIn(8)) {
        desk.hand.askForMenu(port);
    } else {
        desk.hand.click(port, Qt::LeftButton, desk.hand.oneIn(3) ? Qt::ControlModifier : Qt::NoModifier);
    }
    return QStringLiteral("branch list");
}

}   // namespace

std::vector<ToolPreference> vesselPreferences()
{
    return {{5, workInTreeView}, {5, workInSlices}, {2, editTree}, {6, clickBranch}};
}

}   // namespace angiopose::test

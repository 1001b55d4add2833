#include "app/menus/menu_controller.h"

#include "app/editing/branch_controller.h"
#include "app/preferences/save_folder.h"
#include "ui/actions/window_actions.h"
#include "ui/dialogs/message_dialog.h"
#include "ui/panels/bottom_strip.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tree_view.h"

#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMenu>
#include <QPixmap>
#include <initializer_list>

namespace angiopose::app {
namespace {

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

/// Creates the menu, starting with the commands for the branch under the mouse, which is also selected.
QMenu* MenuController::createMenu(std::optional<int> branchId)
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
    addCommands(menu, actions_, {ui::Command::ToggleAuxiliary, ui::Command::ToggleExcluded});
    return menu;
}

void MenuController::showAngiogramMenu(const QPoint& globalPosition, std::optional<int> branchId)
{
    using enum ui::Command;
    QMenu* menu = createMenu(branchId);
    addCommands(menu, actions_, {Nudge, PickPivot, CentroidPivot, ResetPose, Register});
    addCommands(menu, actions_, {Fit, WorstBranch, AutoWindow, Invert});
    addCommands(menu, actions_, {Outline, Swipe, Flicker, ShowTrace});
    addCommands(menu, actions_, {ExportOverlay, CopyScreenshot});
    menu->popup(globalPosition);
}

void MenuController::showTreeMenu(const QPoint& globalPosition, std::optional<int> branchId)
{
    using enum ui::Command;
    QMenu* menu = createMenu(branchId);
    addCommands(menu, actions_, {SelectAll, AuxiliaryInView, AuxiliaryLargeVessels});
    addCommands(menu, actions_, {ResetTreeView, CopyScreenshot});
    menu->popup(globalPosition);
}

ScreenshotController::ScreenshotController(ui::WindowActions& actions, ui::BottomStrip& strip, QWidget& window,
                                           QObject* parent)
    : QObject(parent), strip_(strip), window_(window)
{
    connect(actions[ui::Command::CopyScreenshot], &QAction::triggered, this, &ScreenshotController::copy);
    connect(actions[ui::Command::SaveScreenshot], &QAction::triggered, this, &ScreenshotController::askForFile);
}

void ScreenshotController::copy()
{
    QGuiApplication::clipboard()->setPixmap(window_.grab());
    strip_.showStatus(tr("Screenshot copied to the clipboard"));
}

void ScreenshotController::askForFile()
{
    const QPixmap picture = window_.grab();   // captured before the dialog covers the window
    QMetaObject::invokeMethod(
        this, [this, picture] { askForPictureFile(picture); }, Qt::QueuedConnection);
}

void ScreenshotController::askForPictureFile(const QPixmap& picture)
{
    const QString suggested = suggestedPath({}, QStringLiteral("angiopose.png"));
    auto* dialog = new QFileDialog(&window_, tr("Save screenshot"), suggested, tr("PNG images (*.png)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("png"));
    connect(dialog, &QFileDialog::fileSelected, this, [this, picture](const QString& path) {
        if (picture.save(path, "PNG")) {
            rememberSaveFolder(path);
            strip_.showStatus(tr("Saved: %1").arg(QFileInfo(path).fileName()));
        } else {
            ui::MessageDialog::show(
                {tr("Could not save the image"), tr("Could not write %1. Choose another folder.").arg(path), {}},
                &window_);
        }
    });
    dialog->open();
}

}   // namespace angiopose::app

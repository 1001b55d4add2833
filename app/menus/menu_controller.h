#pragma once

#include <QObject>
#include <optional>

class QMenu;
class QPixmap;
class QPoint;
class QWidget;

namespace angiopose::ui {
class AngiogramView;
class BottomStrip;
class TreeView;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

class BranchController;

/// Provides the context menus (right click or menu key) of the two views, with commands for the item under the pointer.
class MenuController : public QObject {
    Q_OBJECT
public:
    MenuController(BranchController& branches, ui::WindowActions& actions, ui::AngiogramView& view,
                   ui::TreeView& treeView, QWidget& menuParent, QObject* parent = nullptr);

private:
    void showAngiogramMenu(const QPoint& globalPosition, std::optional<int> branchId);
    void showTreeMenu(const QPoint& globalPosition, std::optional<int> branchId);
    QMenu* createMenu(std::optional<int> branchId);

    BranchController& branches_;
    ui::WindowActions& actions_;
    QWidget& menuParent_;
};

/// Takes screenshots of the whole window, to the clipboard or to a file.
class ScreenshotController : public QObject {
    Q_OBJECT
public:
    ScreenshotController(ui::WindowActions& actions, ui::BottomStrip& strip, QWidget& window,
                         QObject* parent = nullptr);

private:
    void copy();
    void askForFile();
    void askForPictureFile(const QPixmap& picture);   ///< called in a separate event: capturing the window and opening
                                                      ///< the dialog each take most of the time budget of an event

    ui::BottomStrip& strip_;
    QWidget& window_;
};

}   // namespace angiopose::app

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

/// The menus behind a right click (or the menu key) in the two views: the commands that fit what lies there.
class MenuController : public QObject {
    Q_OBJECT
public:
    MenuController(BranchController& branches, ui::WindowActions& actions, ui::AngiogramView& view,
                   ui::TreeView& treeView, QWidget& menuParent, QObject* parent = nullptr);

private:
    void showAngiogramMenu(const QPoint& globalPosition, std::optional<int> branchId);
    void showTreeMenu(const QPoint& globalPosition, std::optional<int> branchId);
    QMenu* makeMenu(std::optional<int> branchId);

    BranchController& branches_;
    ui::WindowActions& actions_;
    QWidget& menuParent_;
};

/// Pictures of the whole window, as it is: to the clipboard, or into a file.
class PictureController : public QObject {
    Q_OBJECT
public:
    PictureController(ui::WindowActions& actions, ui::BottomStrip& strip, QWidget& window, QObject* parent = nullptr);

private:
    void copy();
    void askFile();
    void askFileFor(const QPixmap& picture);   ///< in an event of its own: either takes most of what one may take

    ui::BottomStrip& strip_;
    QWidget& window_;
};

}   // namespace angiopose::app

#pragma once

#include <QObject>

#include <optional>

class QMenu;
class QPoint;

class QWidget;

namespace angiopose::ui {
class AngiogramView;
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

}   // namespace angiopose::app
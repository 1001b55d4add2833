#pragma once

#include <QObject>

#include <optional>

class QMenu;
class QPoint;

namespace angiopose::ui {
class MainWindow;
}

namespace angiopose::app {

class BranchController;

/// The menus behind a right click (or the menu key) in the two views: the commands that fit what lies there.
class MenuController : public QObject {
    Q_OBJECT
public:
    MenuController(BranchController& branches, ui::MainWindow& window, QObject* parent = nullptr);

private:
    void showAngiogramMenu(const QPoint& globalPosition, std::optional<int> branchId);
    void showTreeMenu(const QPoint& globalPosition, std::optional<int> branchId);
    QMenu* makeMenu(std::optional<int> branchId);

    BranchController& branches_;
    ui::MainWindow& window_;
};

}   // namespace angiopose::app
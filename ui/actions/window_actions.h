#pragma once

#include "ui/actions/command_table.h"
#include "ui/actions/fixed_shortcuts.h"
#include "ui/actions/mouse_preset.h"

#include <QAction>
#include <QObject>

#include <map>
#include <vector>

class QMenu;
class QMenuBar;
class QWidget;

namespace angiopose::ui {

/// Named actions of the main window with their shortcuts, built from the table that also feeds the menus and the
/// shortcut sheet.
class WindowActions : public QObject {
    Q_OBJECT
public:
    explicit WindowActions(QWidget* window);

    QAction* operator[](Command command) const { return actions_.at(command); }
    QMenu* recentMenu() const { return recent_; }
    void fillMenus(QMenuBar* menuBar);
    /// Lists every command with its shortcut, the fixed keys and the mouse actions.
    std::vector<ShortcutRow> shortcutRows(const MousePreset& mouse) const;

private:
    void addCommand(const CommandRow& row, QWidget* window);

    std::map<Command, QAction*> actions_;
    QMenu* recent_;
    QMenu* exports_;
};

}   // namespace angiopose::ui

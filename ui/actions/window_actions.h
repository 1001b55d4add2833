#pragma once

#include "ui/actions/command_table.h"
#include "ui/actions/key_notes.h"
#include "ui/actions/mouse_preset.h"

#include <QAction>
#include <QObject>

#include <map>
#include <vector>

class QMenu;
class QMenuBar;
class QWidget;

namespace angiopose::ui {

/// The window's named actions with their keys, made from the table that also feeds menus and key sheet.
class WindowActions : public QObject {
    Q_OBJECT
public:
    explicit WindowActions(QWidget* window);

    QAction* operator[](Command command) const { return actions_.at(command); }
    QMenu* recentMenu() const { return recent_; }
    void fillMenus(QMenuBar* menuBar);
    /// Every command with its key, the keys that are fixed, and what the mouse does.
    std::vector<KeyLine> keySheet(const MousePreset& mouse) const;

private:
    void addCommand(const CommandRow& row, QWidget* window);

    std::map<Command, QAction*> actions_;
    QMenu* recent_;
    QMenu* exports_;
};

}   // namespace angiopose::ui
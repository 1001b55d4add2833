#pragma once

#include "ui/actions/mouse_preset.h"
#include "ui/dialogs/key_sheet.h"

#include <QKeySequence>
#include <QList>
#include <QObject>
#include <map>
#include <vector>

class QAction;
class QWidget;

namespace angiopose::ui {
class AngiogramView;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Returns the mouse preset that the user chose.
ui::MousePreset mousePresetSetting();

/// Provides the mouse menu, which assigns actions to the mouse buttons on the angiogram.
class MousePresetController : public QObject {
    Q_OBJECT
public:
    MousePresetController(ui::WindowActions& actions, ui::AngiogramView& view, QObject* parent = nullptr);
};

/// Manages the shortcut sheet and the user-defined shortcuts, which persist between sessions, at most one per command.
class ShortcutController : public QObject {
    Q_OBJECT
public:
    ShortcutController(ui::WindowActions& actions, QWidget& dialogParent, QObject* parent = nullptr);

    void openSheet();

private:
    std::vector<ui::ShortcutRow> sheetRows() const;
    void loadStored();
    void choose(QAction* action, const QKeySequence& key);
    void resetAll();
    void refresh();

    ui::WindowActions& actions_;
    QWidget& dialogParent_;
    std::map<QAction*, QList<QKeySequence>> defaultShortcuts_;   ///< default shortcuts of the program
    ui::KeySheet* sheet_ = nullptr;
    bool shortcutsChanged_ = false;   ///< true if shortcuts have changed since the sheet was opened
};

}   // namespace angiopose::app

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

/// The preset that the user chose.
ui::MousePreset chosenMouse();

/// The mouse menu: which button does what on the angiogram.
class MouseController : public QObject {
    Q_OBJECT
public:
    MouseController(ui::WindowActions& actions, ui::AngiogramView& view, QObject* parent = nullptr);
};

/// The key sheet, and the keys that the user chose in it: kept between sessions, each command at most one user's key.
class ShortcutController : public QObject {
    Q_OBJECT
public:
    ShortcutController(ui::WindowActions& actions, QWidget& dialogParent, QObject* parent = nullptr);

    void openSheet();

private:
    std::vector<ui::KeyLine> keyLines() const;
    void readStored();
    void choose(QAction* action, const QKeySequence& key);
    void resetAll();
    void refresh();

    ui::WindowActions& actions_;
    QWidget& dialogParent_;
    std::map<QAction*, QList<QKeySequence>> usual_;   ///< as the program brings them
    ui::KeySheet* sheet_ = nullptr;
    bool areNew_ = false;   ///< since the sheet was opened
};

}   // namespace angiopose::app

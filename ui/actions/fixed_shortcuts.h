#pragma once

#include "ui/actions/mouse_preset.h"

#include <QString>
#include <vector>

class QAction;

namespace angiopose::ui {

/// One line of the shortcut sheet.
struct ShortcutRow {
    QString heading;   ///< mode or view in which the shortcuts work
    QString keys;
    QString effect;
    QAction* action = nullptr;   ///< action with an editable shortcut; null for fixed keys
};

/// Lists the fixed keys by mode and view, and the mouse actions.
std::vector<ShortcutRow> fixedShortcuts(const MousePreset& mouse);

}   // namespace angiopose::ui

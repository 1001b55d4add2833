#pragma once

#include "ui/actions/mouse_preset.h"

#include <QString>
#include <vector>

class QAction;

namespace angiopose::ui {

/// One line of the key sheet.
struct KeyLine {
    QString heading;   ///< where the key works
    QString keys;
    QString effect;
    QAction* action = nullptr;   ///< whose key can be changed; null where it is fixed
};

/// The keys that are fixed, mode by mode and view by view, and what the mouse does.
std::vector<KeyLine> keyNotes(const MousePreset& mouse);

}   // namespace angiopose::ui

#pragma once

#include "ui/dialogs/key_sheet.h"
#include "ui/views/mouse_preset.h"

#include <vector>

namespace angiopose::ui {

/// The keys that are fixed, mode by mode and view by view, and what the mouse does.
std::vector<KeyLine> keyNotes(const MousePreset& mouse);

}   // namespace angiopose::ui
#pragma once

#include "ui/actions/key_line.h"
#include "ui/actions/mouse_preset.h"

#include <vector>

namespace angiopose::ui {

/// The keys that are fixed, mode by mode and view by view, and what the mouse does.
std::vector<KeyLine> keyNotes(const MousePreset& mouse);

}   // namespace angiopose::ui
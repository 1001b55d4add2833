#pragma once

#include "ui/theme/theme.h"

#include <string>

namespace angiopose::ui {

/// Returns the style sheet of the panels: colors by the `role` property of labels, buttons and fields.
std::string panelStyleSheet(const Palette& tones);

}   // namespace angiopose::ui
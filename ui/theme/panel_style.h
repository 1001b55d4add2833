#pragma once

#include "ui/theme/theme.h"

#include <string>

namespace angiopose::ui {

/// Style sheet of the panels: tones by the `role` property of labels, buttons and fields.
std::string panelStyleSheet(const Palette& tones);

}   // namespace angiopose::ui
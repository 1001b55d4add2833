#pragma once

#include "ui/actions/command.h"
#include "ui/words/spoken.h"

class QAction;
class QPushButton;

namespace angiopose::ui {

/// A button for a mode, its key in its tip; see `follow`.
QPushButton* modeButton(const Words& text, Command command);

/// Makes a button do what an action does, and be as the action is.
void follow(QPushButton& button, QAction& action);

}   // namespace angiopose::ui

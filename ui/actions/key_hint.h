#pragma once

#include "ui/actions/command.h"
#include "ui/words/retranslation.h"

#include <QString>
#include <map>

class QAction;
class QPushButton;

namespace angiopose::ui {

/// Sets the user-defined shortcuts as portable text ("" for no shortcut); commands without an entry keep the shortcuts
/// of the command table. Applies to the whole program, like theme and language; see `retranslate`.
void setCustomShortcuts(std::map<Command, QString> shortcuts);

QString keyOf(Command command);   ///< "" if the command has no shortcut

/// Appends the shortcut to a label, e.g. "Register  R".
QString withShortcut(const QString& message, Command command);

/// Appends the shortcut to a tooltip, e.g. "Finds the pose. (R)".
QString tooltipWithShortcut(const QString& sentence, Command command);

/// Creates a button that switches a mode on and off, with the shortcut in the tooltip; see `follow`.
QPushButton* makeModeButton(const LocalizedText& text, Command command);

/// Makes a button trigger an action and mirror its checked and enabled state.
void follow(QPushButton& button, QAction& action);

}   // namespace angiopose::ui

#pragma once

#include "ui/actions/command.h"
#include "ui/words/spoken.h"

#include <QString>
#include <map>

class QAction;
class QPushButton;

namespace angiopose::ui {

/// The keys the user chose, as people write them ("" for none); the others have those of the command table. Like theme
/// and language one choice for the whole program: see `speakAgain`.
void setChosenKeys(std::map<Command, QString> chosen);

QString keyOf(Command command);   ///< "" when it has none

/// "Register  R": the key where the thing is.
QString withKey(const QString& words, Command command);

/// "Finds the pose. (R)": the key behind the sentence of a tool tip.
QString tipWithKey(const QString& sentence, Command command);

/// A button for a mode, its key in its tip; see `follow`.
QPushButton* modeButton(const Words& text, Command command);

/// Makes a button do what an action does, and be as the action is.
void follow(QPushButton& button, QAction& action);

}   // namespace angiopose::ui

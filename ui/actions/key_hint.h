#pragma once

#include "ui/actions/command.h"

#include <QString>

#include <map>

namespace angiopose::ui {

/// The keys the user chose, as people write them ("" for none); the others have those of the command table. Like theme
/// and language one choice for the whole program: see `speakAgain`.
void setChosenKeys(std::map<Command, QString> chosen);

QString keyOf(Command command);   ///< "" when it has none

/// "Register  R": the key where the thing is.
QString withKey(const QString& words, Command command);

/// "Finds the pose. (R)": the key behind the sentence of a tool tip.
QString tipWithKey(const QString& sentence, Command command);

}   // namespace angiopose::ui
#pragma once

#include <QString>
#include <QStringList>

namespace ui {

/// Codes of the languages the window speaks, English first: "en", "de", "zh_CN".
QStringList languages();

/// The first of the desktop's languages that the window speaks; English where it speaks none.
QString desktopLanguage();

/// The language of all words from now on, those of Qt's own dialogs too; see `speakAgain`. Numbers keep their point in
/// all of them.
void applyLanguage(const QString& code);

/// The code that was applied last.
QString currentLanguage();

}   // namespace ui

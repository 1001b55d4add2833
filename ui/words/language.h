#pragma once

#include <QLocale>
#include <QString>
#include <QStringList>

namespace ui {

/// Codes of the languages the window speaks, English first: "en", "de", "zh_CN".
QStringList languages();

/// The first of the desktop's languages that the window speaks; English where it speaks none.
QString desktopLanguage();

/// The language of all words from now on, those of Qt's own dialogs too; see `speakAgain`.
void applyLanguage(const QString& code);

/// The code that was applied last.
QString currentLanguage();

/// How that language writes dates and numbers, wherever the desktop is; see number.h.
QLocale languageLocale();

}   // namespace ui

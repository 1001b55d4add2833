#pragma once

#include <QLocale>
#include <QString>
#include <QStringList>

namespace angiopose::ui {

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

/// Sentences one behind the other: with spaces where the language has them.
QString joinedSentences(const QStringList& sentences);

/// Names one behind the other, with the comma of the language.
QString joinedNames(const QStringList& names);

}   // namespace angiopose::ui
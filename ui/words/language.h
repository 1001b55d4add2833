#pragma once

#include <QLocale>
#include <QString>
#include <QStringList>

namespace angiopose::ui {

/// Codes of the available languages, English first: "en", "de", "zh_CN".
QStringList languages();

/// First of the desktop's languages that is available; English if none is.
QString desktopLanguage();

/// Sets the language of all texts, including Qt's own dialogs; see `speakAgain`.
void applyLanguage(const QString& code);

/// Language code applied last.
QString currentLanguage();

/// Locale for dates and numbers of that language, independent of the desktop; see number.h.
QLocale languageLocale();

/// Joins sentences, with spaces if the language uses them.
QString joinedSentences(const QStringList& sentences);

/// Joins names with the comma of the language.
QString joinedNames(const QStringList& names);

}   // namespace angiopose::ui
#pragma once

#include <QLocale>
#include <QString>
#include <QStringList>

namespace angiopose::ui {

/// Returns the codes of the available languages, English first: "en", "de", "zh_CN".
QStringList languages();

/// Returns the first language in the desktop's list that is available; English if none is.
QString desktopLanguage();

/// Sets the language of all UI text, including Qt's own dialogs; see `retranslate`.
void applyLanguage(const QString& code);

/// Returns the language code set by the last call of `applyLanguage`.
QString currentLanguage();

/// Returns the locale for dates and numbers in the current language, independent of the desktop; see number.h.
QLocale languageLocale();

/// Joins sentences, separated by spaces unless a sentence ends with a full-width full stop.
QString joinSentences(const QStringList& sentences);

/// Joins names with the list separator of the language.
QString joinNames(const QStringList& names);

}   // namespace angiopose::ui

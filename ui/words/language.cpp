#include "ui/words/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

#include <algorithm>

/// Registers the resources of the static library; Q_INIT_RESOURCE must be called outside any namespace.
static void loadTranslations()
{
    Q_INIT_RESOURCE(translations);
}

namespace angiopose::ui {
namespace {

/// Returns whether codes denote the same script, as do "zh-Hans-CN", "zh-CN" and "zh-SG", but not "zh-TW", "zh-Hant".
bool matchesLanguage(const QString& requestedCode, const QString& code)
{
    const QLocale locale(requestedCode);
    if (code == QLatin1String("zh_CN")) {
        return locale.language() == QLocale::Chinese && locale.script() == QLocale::SimplifiedHanScript;
    }
    return locale.language() == QLocale(code).language();
}

QString& currentCode()
{
    static QString code = languages().front();
    return code;
}

void install(QTranslator* translator, bool isLoaded)
{
    if (isLoaded) {
        QCoreApplication::installTranslator(translator);
    }
}

}   // namespace

QStringList languages()
{
    return {QStringLiteral("en"), QStringLiteral("de"), QStringLiteral("zh_CN")};
}

QString desktopLanguage()
{
    for (const QString& requestedCode : QLocale::system().uiLanguages()) {
        const QStringList available = languages();
        const auto match = std::ranges::find_if(
            available, [&requestedCode](const QString& code) { return matchesLanguage(requestedCode, code); });
        if (match != available.end()) {
            return *match;
        }
    }
    return languages().front();
}

void applyLanguage(const QString& code)
{
    loadTranslations();
    currentCode() = code;
    static QTranslator ours, qts;
    for (QTranslator* translator : {&ours, &qts}) {
        QCoreApplication::removeTranslator(translator);
    }
    if (code != languages().front()) {
        install(&qts,
                qts.load(QStringLiteral("qtbase_%1").arg(code), QLibraryInfo::path(QLibraryInfo::TranslationsPath)));
        install(&ours, ours.load(QStringLiteral(":/translations/angiopose_%1.qm").arg(code)));
    }
}

QString currentLanguage()
{
    return currentCode();
}

QLocale languageLocale()
{
    return QLocale(currentCode());
}

QString joinSentences(const QStringList& sentences)
{
    QString text;
    for (const QString& sentence : sentences) {
        const bool needsNoSpace =
            text.isEmpty() || text.endsWith(QChar(0x3002));   // the Chinese full stop is full-width
        text += needsNoSpace ? sentence : QLatin1Char(' ') + sentence;
    }
    return text;
}

QString joinNames(const QStringList& names)
{
    const bool isChinese = languageLocale().language() == QLocale::Chinese;
    return names.join(isChinese ? QString(QChar(0x3001)) : QStringLiteral(", "));
}

}   // namespace angiopose::ui

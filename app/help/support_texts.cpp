#include "app/help/support_texts.h"

#include "app/messages/catalogue.h"
#include "core/messages/catalogue.h"
#include "io/messages/catalogue.h"
#include "ui/actions/command_table.h"
#include "ui/views/gl_driver.h"
#include "ui/words/message_text.h"

#include <QGuiApplication>
#include <QLocale>
#include <QScreen>
#include <QSettings>

#include <algorithm>
#include <array>

namespace angiopose::app {
namespace {

/// Texts that are one of a few names; all others could be anything.
constexpr std::array namedSettings{"window/theme", "window/colors", "window/language", "window/mouse"};

/// What is told in passing stands in no catalogue.
constexpr std::array wordsThatMayPass{
    "opened saved saving written writing packed packing ready stopped finished failed traced tracing registered",
    "could not export open save the file files case pack with without identity converged iterations median trustworthy",
    "geöffnet gespeichert geschrieben gepackt bereit gestoppt fertig fehlgeschlagen nicht datei dateien fall"};

QString valueOf(const QString& key, const QVariant& value)
{
    const bool isNamed =
        std::ranges::any_of(namedSettings, [&key](const char* name) { return key == QLatin1String(name); });
    const QString text = value.toString();
    bool isNumber = false;
    text.toDouble(&isNumber);
    const bool isSwitch = text == QLatin1String("true") || text == QLatin1String("false");
    if (isNamed || isSwitch || (isNumber && text.size() < 7)) {
        return text;
    }
    const bool isEmpty =
        !value.isValid() || (text.isEmpty() && value.toByteArray().isEmpty() && value.toStringList().isEmpty());
    return isEmpty ? QStringLiteral("(none)") : QStringLiteral("(set)");
}

/// "files/lastFolder" may be said, a key with a name in it not: keys of our own have letters and few slashes.
bool isOwnKey(const QString& key)
{
    return key.size() < 40 && key.count(QLatin1Char('/')) <= 2 &&
           std::ranges::all_of(key, [](QChar c) { return c.unicode() < 128 && (c.isLetterOrNumber() || c == u'/'); });
}

}   // namespace

std::string windowFacts()
{
    const ui::GlDriver& driver = ui::glDriver();
    QString facts = QStringLiteral("Qt: %1, built with %2\nplatform: %3\nlocale: %4\n")
                        .arg(QString::fromLatin1(qVersion()), QStringLiteral(QT_VERSION_STR),
                             QGuiApplication::platformName(), QLocale::system().name());
    for (const QScreen* screen : QGuiApplication::screens()) {
        facts += QStringLiteral("screen: %1 x %2 at %3\n")
                     .arg(screen->size().width())
                     .arg(screen->size().height())
                     .arg(screen->devicePixelRatio());
    }
    facts += driver.isThere()
                 ? QStringLiteral("OpenGL: %1, %2, %3\n").arg(driver.version, driver.vendor, driver.renderer)
                 : QStringLiteral("OpenGL: none\n");
    facts += QStringLiteral("angiogram drawn by: %1\n")
                 .arg(ui::chosenRenderer() == ui::Renderer::Vtk ? QStringLiteral("VTK") : QStringLiteral("processor"));
    return facts.toStdString();
}

std::string settingsText()
{
    const QSettings stored;
    QString text;
    for (const QString& key : stored.allKeys()) {
        if (isOwnKey(key)) {
            text += key + QStringLiteral(": ") + valueOf(key, stored.value(key)) + QLatin1Char('\n');
        }
    }
    return text.toStdString();
}

io::KnownWords wordsOfProgram()
{
    io::KnownWords words;
    for (const auto& catalogue : {core::messageCatalogue(), io::messageCatalogue(), messageCatalogue()}) {
        for (const core::MessageEntry* entry : catalogue) {
            words.add(entry->english);
            words.add(ui::messageText(core::Message(*entry, {})).toStdString());
        }
    }
    for (const ui::MenuRows& menu : ui::CommandTable::menus()) {
        for (const ui::CommandRow& row : menu.commands) {
            words.add(row.text);
        }
    }
    for (const char* each : wordsThatMayPass) {
        words.add(each);
    }
    words.add("name path file uid date");   // what stands in place of what was taken out
    return words;
}

}   // namespace angiopose::app

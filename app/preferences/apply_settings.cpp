#include "app/preferences/apply_settings.h"

#include "app/preferences/settings.h"
#include "ui/actions/command_table.h"
#include "ui/actions/key_hint.h"
#include "ui/theme/active_theme.h"
#include "ui/views/gl_driver.h"
#include "ui/words/language.h"

#include <QCoreApplication>
#include <QKeySequence>
#include <QSettings>

namespace angiopose::app {

void applyLanguageSetting()
{
    const QString choice = settings::language.read();
    ui::applyLanguage(choice == QLatin1String("system") ? ui::desktopLanguage() : choice);
}

void applyShortcutSettings()
{
    const QSettings stored;
    std::map<ui::Command, QString> shortcuts;
    for (const ui::MenuRows& menu : ui::CommandTable::menus()) {
        for (const ui::CommandRow& row : menu.commands) {
            const QVariant keys = stored.value(QStringLiteral("keys/") + QLatin1String(row.name));
            if (keys.isValid()) {
                shortcuts[row.command] =
                    QKeySequence::listFromString(keys.toString()).value(0).toString(QKeySequence::NativeText);
            }
        }
    }
    ui::setCustomShortcuts(std::move(shortcuts));
}

void applyThemeSetting(QApplication& application)
{
    static const ui::ThemeMode desktop = ui::systemTheme(application);   // read before the first theme overrides it
    const QString choice = settings::theme.read();
    if (choice == QLatin1String("system")) {
        ui::applyTheme(application, desktop);
    } else {
        ui::applyTheme(application, choice == QLatin1String("light") ? ui::ThemeMode::Light : ui::ThemeMode::Dark);
    }
}

QCommandLineOption rendererOption()
{
    return {QStringLiteral("renderer"),
            QCoreApplication::translate("main",
                                        "Renderer of the angiogram: vtk (OpenGL), painter (CPU), or auto (vtk if a "
                                        "graphics card supports OpenGL)."),
            QStringLiteral("auto|vtk|painter"), QStringLiteral("auto")};
}

QString rendererOf(const QCommandLineParser& parser)
{
    return parser.value(QStringLiteral("renderer"));
}

bool applyRenderer(const QCommandLineParser& parser)
{
    const QString name = rendererOf(parser);
    if (name == QLatin1String("vtk")) {
        ui::chooseRenderer(ui::RendererChoice::Vtk);
    } else if (name == QLatin1String("painter")) {
        ui::chooseRenderer(ui::RendererChoice::Painter);
    }
    return name == QLatin1String("vtk") || name == QLatin1String("painter") || name == QLatin1String("auto");
}

}   // namespace angiopose::app

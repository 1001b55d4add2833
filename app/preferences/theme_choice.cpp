#include "app/preferences/theme_choice.h"

#include "app/preferences/settings.h"
#include "ui/theme/active_theme.h"

namespace angiopose::app {

void applyChosenTheme(QApplication& application)
{
    static const ui::ThemeMode desktop = ui::systemTheme(application);   // before the first theme hides it
    const QString choice = settings::theme.read();
    if (choice == QLatin1String("system")) {
        ui::applyTheme(application, desktop);
    } else {
        ui::applyTheme(application, choice == QLatin1String("light") ? ui::ThemeMode::Light : ui::ThemeMode::Dark);
    }
}

}   // namespace angiopose::app
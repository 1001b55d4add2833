#include "app/preferences/language_choice.h"

#include "app/preferences/settings.h"
#include "ui/words/language.h"

namespace angiopose::app {

void applyChosenLanguage()
{
    const QString choice = settings::language.read();
    ui::applyLanguage(choice == QLatin1String("system") ? ui::desktopLanguage() : choice);
}

}   // namespace angiopose::app
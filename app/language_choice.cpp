#include "app/language_choice.h"

#include "app/settings.h"
#include "ui/words/language.h"

namespace app {

void applyChosenLanguage()
{
    const QString choice = settings::language.read();
    ui::applyLanguage(choice == QLatin1String("system") ? ui::desktopLanguage() : choice);
}

}   // namespace app

#include "app/habits/language_controller.h"

#include "app/preferences/language_choice.h"
#include "app/preferences/settings.h"
#include "ui/actions/window_actions.h"
#include "ui/words/spoken.h"

#include <QDialog>

#include <array>
#include <utility>

namespace angiopose::app {

LanguageController::LanguageController(ui::WindowActions& actions, QWidget& window, QObject* parent)
    : QObject(parent), window_(window)
{
    const std::array choices{
        std::pair{ui::Command::LanguageSystem, "system"}, std::pair{ui::Command::LanguageEnglish, "en"},
        std::pair{ui::Command::LanguageGerman, "de"}, std::pair{ui::Command::LanguageChinese, "zh_CN"}};
    for (const auto& [command, name] : choices) {
        const QString code = QString::fromLatin1(name);
        QAction* action = actions[command];
        action->setChecked(settings::language.read() == code);
        connect(action, &QAction::triggered, this, [this, code] { choose(code); });
    }
}

void LanguageController::choose(const QString& code)
{
    if (code == settings::language.read()) {
        return;
    }
    settings::language.write(code);
    for (QDialog* open : window_.findChildren<QDialog*>()) {
        open->reject();   // made anew in the other words
    }
    applyChosenLanguage();
    ui::speakAgain();
}

}   // namespace angiopose::app
#include "app/menus/language_controller.h"

#include "app/preferences/apply_settings.h"
#include "app/preferences/settings.h"
#include "ui/actions/window_actions.h"
#include "ui/theme/active_theme.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tree_view.h"
#include "ui/words/retranslation.h"

#include <QDialog>
#include <algorithm>
#include <array>
#include <utility>

namespace angiopose::app {
namespace {

struct ColorChoice {
    ui::Command command;
    const char* name;
    ui::ColorScheme scheme;
};

constexpr std::array colorChoices{
    ColorChoice{ui::Command::ColorsBlueAmber, "blue-amber", ui::ColorScheme::BlueAmber},
    ColorChoice{ui::Command::ColorsBlueRed, "blue-red", ui::ColorScheme::BlueRed},
    ColorChoice{ui::Command::ColorsBrightness, "brightness", ui::ColorScheme::Brightness}};

const ColorChoice& chosenColors()
{
    const QString name = settings::colors.read();
    const auto* found = std::ranges::find_if(
        colorChoices, [&name](const ColorChoice& choice) { return name == QLatin1String(choice.name); });
    return found == colorChoices.end() ? colorChoices.front() : *found;
}

}   // namespace

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
        open->reject();   // the dialog will be reopened in the new language
    }
    applyLanguageSetting();
    ui::retranslate();
}

void applyColorSetting()
{
    ui::setColorScheme(chosenColors().scheme);
}

ColorController::ColorController(ui::WindowActions& actions, ui::AngiogramView& view, ui::TreeView& treeView,
                                 QWidget& window, QObject* parent)
    : QObject(parent), view_(view), treeView_(treeView), window_(window)
{
    for (const ColorChoice& choice : colorChoices) {
        connect(actions[choice.command], &QAction::triggered, this, [this, &choice] {
            settings::colors.write(QString::fromLatin1(choice.name));
            apply(choice.scheme);
        });
    }
    actions[chosenColors().command]->setChecked(true);
    apply(chosenColors().scheme);
}

void ColorController::apply(ui::ColorScheme scheme)
{
    ui::setColorScheme(scheme);
    view_.scene().recolor();
    view_.redraw();
    treeView_.setTheme(ui::activeTheme());
    for (QWidget* part : window_.findChildren<QWidget*>()) {
        part->update();
    }
}

}   // namespace angiopose::app

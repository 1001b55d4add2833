#include "ui/actions/key_hint.h"

#include "ui/actions/command_table.h"

#include <QAction>
#include <QKeySequence>
#include <QPushButton>
#include <utility>

namespace angiopose::ui {
namespace {

std::map<Command, QString> usualKeys()
{
    std::map<Command, QString> keys;
    for (const MenuRows& menu : CommandTable::menus()) {
        for (const CommandRow& row : menu.commands) {
            const auto all = QKeySequence::listFromString(QString::fromLatin1(row.keys));
            keys[row.command] = all.isEmpty() ? QString() : all.front().toString(QKeySequence::NativeText);
        }
    }
    return keys;
}

std::map<Command, QString>& chosenKeys()
{
    static std::map<Command, QString> chosen;
    return chosen;
}

}   // namespace

void setChosenKeys(std::map<Command, QString> chosen)
{
    chosenKeys() = std::move(chosen);
}

QString keyOf(Command command)
{
    const auto chosen = chosenKeys().find(command);
    return chosen != chosenKeys().end() ? chosen->second : usualKeys()[command];
}

QString withKey(const QString& words, Command command)
{
    const QString key = keyOf(command);
    return key.isEmpty() ? words : words + QStringLiteral("  ") + key;
}

QString tipWithKey(const QString& sentence, Command command)
{
    const QString key = keyOf(command);
    return key.isEmpty() ? sentence : sentence + QStringLiteral(" (%1)").arg(key);
}

QPushButton* modeButton(const Words& text, Command command)
{
    auto* button = withText(new QPushButton, text);
    withTip(button, [text, command] { return withKey(text(), command); });
    button->setCheckable(true);
    return button;
}

void follow(QPushButton& button, QAction& action)
{
    QObject::connect(&button, &QPushButton::clicked, &action, [&action](bool on) {
        if (action.isCheckable()) {
            action.setChecked(on);
        } else {
            action.trigger();
        }
    });
    const auto look = [&button, &action] {
        button.setEnabled(action.isEnabled());
        button.setChecked(action.isChecked());
    };
    QObject::connect(&action, &QAction::changed, &button, look);
    look();
}

}   // namespace angiopose::ui

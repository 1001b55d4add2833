#include "ui/actions/key_hint.h"

#include "ui/actions/command_table.h"

#include <QAction>
#include <QKeySequence>
#include <QPushButton>
#include <utility>

namespace angiopose::ui {
namespace {

std::map<Command, QString> defaultShortcuts()
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

std::map<Command, QString>& customShortcuts()
{
    static std::map<Command, QString> shortcuts;
    return shortcuts;
}

}   // namespace

void setCustomShortcuts(std::map<Command, QString> shortcuts)
{
    customShortcuts() = std::move(shortcuts);
}

QString keyOf(Command command)
{
    const auto shortcuts = customShortcuts().find(command);
    return shortcuts != customShortcuts().end() ? shortcuts->second : defaultShortcuts()[command];
}

QString withShortcut(const QString& message, Command command)
{
    const QString key = keyOf(command);
    return key.isEmpty() ? message : message + QStringLiteral("  ") + key;
}

QString tooltipWithShortcut(const QString& sentence, Command command)
{
    const QString key = keyOf(command);
    return key.isEmpty() ? sentence : sentence + QStringLiteral(" (%1)").arg(key);
}

QPushButton* makeModeButton(const LocalizedText& text, Command command)
{
    auto* button = withText(new QPushButton, text);
    withToolTip(button, [text, command] { return withShortcut(text(), command); });
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
    const auto updateButton = [&button, &action] {
        button.setEnabled(action.isEnabled());
        button.setChecked(action.isChecked());
    };
    QObject::connect(&action, &QAction::changed, &button, updateButton);
    updateButton();
}

}   // namespace angiopose::ui

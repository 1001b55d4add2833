#include "ui/actions/key_hint.h"

#include "ui/actions/command_table.h"

#include <QKeySequence>

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

}   // namespace angiopose::ui
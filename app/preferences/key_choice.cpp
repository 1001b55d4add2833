#include "app/preferences/key_choice.h"

#include "ui/actions/command_table.h"
#include "ui/actions/key_hint.h"

#include <QKeySequence>
#include <QSettings>

namespace angiopose::app {

void applyChosenKeys()
{
    const QSettings stored;
    std::map<ui::Command, QString> chosen;
    for (const ui::MenuRows& menu : ui::CommandTable::menus()) {
        for (const ui::CommandRow& row : menu.commands) {
            const QVariant keys = stored.value(QStringLiteral("keys/") + row.name());
            if (keys.isValid()) {
                chosen[row.command] =
                    QKeySequence::listFromString(keys.toString()).value(0).toString(QKeySequence::NativeText);
            }
        }
    }
    ui::setChosenKeys(std::move(chosen));
}

}   // namespace angiopose::app
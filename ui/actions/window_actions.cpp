#include "ui/actions/window_actions.h"

#include "ui/actions/fixed_shortcuts.h"
#include "ui/words/retranslation.h"

#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>

#include <algorithm>
#include <array>
#include <iterator>

namespace angiopose::ui {
namespace {

constexpr std::array choices{Menu::Colors, Menu::Theme, Menu::Language, Menu::Mouse};   ///< exclusive choices

bool isChoice(Menu menu)
{
    return std::ranges::find(choices, menu) != choices.end();
}

bool liesInView(Menu menu)
{
    return isChoice(menu) || menu == Menu::Places || menu == Menu::Brightness;
}

QList<QKeySequence> shortcutsOf(const CommandRow& row)
{
    const QString keys = QString::fromLatin1(row.keys);
    return keys.isEmpty() ? QList<QKeySequence>() : QKeySequence::listFromString(keys);
}

}   // namespace

WindowActions::WindowActions(QWidget* window) : QObject(window), recent_(new QMenu(window)), exports_(new QMenu(window))
{
    keepTranslated(this, [this] { recent_->setTitle(tr("Open recent")); });
    for (const MenuRows& menu : CommandTable::menus()) {
        auto* group = isChoice(menu.menu) ? new QActionGroup(this) : nullptr;
        for (const CommandRow& row : menu.commands) {
            addCommand(row, window);
            if (group) {
                group->addAction(actions_.at(row.command));
            }
        }
    }
}

void WindowActions::addCommand(const CommandRow& row, QWidget* window)
{
    auto* action = withText(new QAction(this), [text = row.text] { return CommandTable::tr(text); });
    action->setObjectName(QLatin1String(row.name));
    action->setCheckable(row.traits & CommandTable::Switch);
    action->setAutoRepeat(row.traits & CommandTable::Repeats);
    action->setShortcuts(shortcutsOf(row));
    window->addAction(action);
    actions_[row.command] = action;
}

void WindowActions::fillMenus(QMenuBar* menuBar)
{
    const std::map<Command, QMenu*> submenuAfter{{Command::OpenSample, recent_}, {Command::ExportOverlay, exports_}};
    std::map<Menu, QMenu*> menus{{Menu::Exports, exports_}};
    for (const MenuRows& rows : CommandTable::menus()) {
        QMenu*& menu = menus[rows.menu];
        if (!menu) {
            menu = liesInView(rows.menu) ? menus.at(Menu::View)->addMenu(QString()) : menuBar->addMenu(QString());
        }
        keepTranslated(menu, [menu, title = rows.title] { menu->setTitle(CommandTable::tr(title)); });
        for (const CommandRow& row : rows.commands) {
            if (row.traits & CommandTable::StartsGroup) {
                menu->addSeparator();
            }
            menu->addAction(actions_.at(row.command));
            if (const auto submenu = submenuAfter.find(row.command); submenu != submenuAfter.end()) {
                menu->addMenu(submenu->second);
            }
        }
    }
}

std::vector<ShortcutRow> WindowActions::shortcutRows(const MousePreset& mouse) const
{
    std::vector<ShortcutRow> lines;
    for (const MenuRows& menu : CommandTable::menus()) {
        for (const CommandRow& row : menu.commands) {
            QAction* action = actions_.at(row.command);
            lines.push_back({tr("Anywhere in the window"),
                             QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText),
                             CommandTable::tr(row.text), action});
        }
    }
    std::ranges::move(fixedShortcuts(mouse), std::back_inserter(lines));
    return lines;
}

}   // namespace angiopose::ui

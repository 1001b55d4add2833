#include "app/menus/shortcut_controller.h"

#include "app/preferences/apply_settings.h"
#include "app/preferences/settings.h"
#include "ui/actions/window_actions.h"
#include "ui/views/angiogram_view.h"
#include "ui/words/retranslation.h"

#include <QSettings>
#include <algorithm>
#include <array>
#include <utility>

namespace angiopose::app {
namespace {

struct MouseChoice {
    ui::Command command;
    const char* name;
    ui::MousePreset preset;
};

constexpr std::array mouseChoices{MouseChoice{ui::Command::MouseRadiology, "radiology", ui::radiologyMouse},
                                  MouseChoice{ui::Command::MouseSlicer, "slicer", ui::slicerMouse},
                                  MouseChoice{ui::Command::MouseScroll, "scroll", ui::scrollMouse}};

const MouseChoice& chosenMouseChoice()
{
    const QString name = settings::mouse.read();
    const auto* found = std::ranges::find_if(
        mouseChoices, [&name](const MouseChoice& choice) { return name == QLatin1String(choice.name); });
    return found == mouseChoices.end() ? mouseChoices.front() : *found;
}

/// Returns the settings key for the shortcuts of a command, derived from its object name.
QString settingOf(const QAction* action)
{
    return QStringLiteral("keys/%1").arg(action->objectName());
}

/// Parses stored shortcuts, which are separated by "; "; returns an empty list for an empty string.
QList<QKeySequence> keysOf(const QString& stored)
{
    return stored.isEmpty() ? QList<QKeySequence>() : QKeySequence::listFromString(stored);
}

}   // namespace

ui::MousePreset mousePresetSetting()
{
    return chosenMouseChoice().preset;
}

MousePresetController::MousePresetController(ui::WindowActions& actions, ui::AngiogramView& view, QObject* parent)
    : QObject(parent)
{
    for (const MouseChoice& choice : mouseChoices) {
        connect(actions[choice.command], &QAction::triggered, this, [&view, &choice] {
            settings::mouse.write(QString::fromLatin1(choice.name));
            view.setMousePreset(choice.preset);
        });
    }
    actions[chosenMouseChoice().command]->setChecked(true);
    view.setMousePreset(mousePresetSetting());
}

ShortcutController::ShortcutController(ui::WindowActions& actions, QWidget& dialogParent, QObject* parent)
    : QObject(parent), actions_(actions), dialogParent_(dialogParent)
{
    for (const ui::ShortcutRow& line : sheetRows()) {
        if (line.action) {
            defaultShortcuts_[line.action] = line.action->shortcuts();
        }
    }
    loadStored();
    connect(actions_[ui::Command::Keys], &QAction::triggered, this, &ShortcutController::openSheet);
}

std::vector<ui::ShortcutRow> ShortcutController::sheetRows() const
{
    return actions_.shortcutRows(mousePresetSetting());
}

void ShortcutController::loadStored()
{
    const QSettings stored;
    for (const auto& [action, keys] : defaultShortcuts_) {
        const QVariant chosen = stored.value(settingOf(action));
        action->setShortcuts(chosen.isValid() ? keysOf(chosen.toString()) : keys);
    }
}

void ShortcutController::openSheet()
{
    if (sheet_) {
        return;
    }
    sheet_ = new ui::KeySheet(sheetRows(), &dialogParent_);
    connect(sheet_, &ui::KeySheet::keyChosen, this, &ShortcutController::choose);
    connect(sheet_, &ui::KeySheet::resetRequested, this, &ShortcutController::resetAll);
    connect(sheet_, &QDialog::finished, this, [this] {
        if (std::exchange(shortcutsChanged_, false)) {   // updates the shortcuts shown on buttons and in tooltips
            applyShortcutSettings();
            ui::retranslate();
        }
    });
    connect(sheet_, &QObject::destroyed, this, [this] { sheet_ = nullptr; });
    sheet_->open();
}

void ShortcutController::choose(QAction* action, const QKeySequence& key)
{
    QSettings stored;
    const auto give = [&stored](QAction* to, const QList<QKeySequence>& keys) {
        to->setShortcuts(keys);
        stored.setValue(settingOf(to), QKeySequence::listToString(keys));
    };
    for (const auto& [other, usual] : defaultShortcuts_) {
        QList<QKeySequence> keys = other->shortcuts();
        if (other != action && !key.isEmpty() && keys.removeAll(key) > 0) {
            give(other, keys);
        }
    }
    give(action, key.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{key});
    refresh();
}

void ShortcutController::resetAll()
{
    QSettings().remove(QStringLiteral("keys"));
    loadStored();
    refresh();
}

void ShortcutController::refresh()
{
    shortcutsChanged_ = true;
    if (sheet_) {
        sheet_->showRows(sheetRows());
    }
}

}   // namespace angiopose::app

#include "app/habits/shortcut_controller.h"

#include "app/habits/mouse_controller.h"
#include "app/preferences/key_choice.h"
#include "ui/actions/window_actions.h"
#include "ui/words/spoken.h"

#include <QSettings>

#include <utility>

namespace angiopose::app {
namespace {

/// Settings group of the keys; each command under its object name.
QString settingOf(const QAction* action)
{
    return QStringLiteral("keys/%1").arg(action->objectName());
}

/// As stored: separated by "; ", nothing where there is no key.
QList<QKeySequence> keysOf(const QString& stored)
{
    return stored.isEmpty() ? QList<QKeySequence>() : QKeySequence::listFromString(stored);
}

}   // namespace

ShortcutController::ShortcutController(ui::WindowActions& actions, QWidget& dialogParent, QObject* parent)
    : QObject(parent), actions_(actions), dialogParent_(dialogParent)
{
    for (const ui::KeyLine& line : keyLines()) {
        if (line.action) {
            usual_[line.action] = line.action->shortcuts();
        }
    }
    readStored();
    connect(actions_[ui::Command::Keys], &QAction::triggered, this, &ShortcutController::openSheet);
}

std::vector<ui::KeyLine> ShortcutController::keyLines() const
{
    return actions_.keySheet(chosenMouse());
}

void ShortcutController::readStored()
{
    const QSettings stored;
    for (const auto& [action, keys] : usual_) {
        const QVariant chosen = stored.value(settingOf(action));
        action->setShortcuts(chosen.isValid() ? keysOf(chosen.toString()) : keys);
    }
}

void ShortcutController::openSheet()
{
    if (sheet_) {
        return;
    }
    sheet_ = new ui::KeySheet(keyLines(), &dialogParent_);
    connect(sheet_, &ui::KeySheet::keyChosen, this, &ShortcutController::choose);
    connect(sheet_, &ui::KeySheet::resetRequested, this, &ShortcutController::resetAll);
    connect(sheet_, &QDialog::finished, this, [this] {
        if (std::exchange(areNew_, false)) {   // buttons and hints name keys
            applyChosenKeys();
            ui::speakAgain();
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
    for (const auto& [other, usual] : usual_) {
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
    readStored();
    refresh();
}

void ShortcutController::refresh()
{
    areNew_ = true;
    if (sheet_) {
        sheet_->showLines(keyLines());
    }
}

}   // namespace angiopose::app
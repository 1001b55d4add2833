#include "ui/dialogs/key_sheet.h"

#include "ui/controls/screen_fit.h"
#include "ui/controls/section.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <utility>

namespace angiopose::ui {
namespace {

constexpr int lineRole = Qt::UserRole;

bool matches(const ShortcutRow& line, const QString& words)
{
    const QString whole = line.keys + QLatin1Char(' ') + line.effect;
    const QStringList parts = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    return std::ranges::all_of(parts,
                               [&whole](const QString& part) { return whole.contains(part, Qt::CaseInsensitive); });
}

bool isModifier(int key)
{
    static constexpr std::array modifiers{Qt::Key_Shift, Qt::Key_Control, Qt::Key_Alt,     Qt::Key_AltGr,
                                          Qt::Key_Meta,  Qt::Key_unknown, Qt::Key_CapsLock};
    return std::ranges::find(modifiers, key) != modifiers.end();
}

/// Returns the key as in shortcuts: "?" instead of "Shift+?", and digits without distinction of the keypad.
QKeySequence keyOf(const QKeyEvent& event)
{
    Qt::KeyboardModifiers modifiers = event.modifiers() & ~Qt::KeypadModifier;
    const bool isSign =
        event.key() > Qt::Key_Space && event.key() < Qt::Key_AsciiTilde && !QChar(event.key()).isLetterOrNumber();
    if (isSign) {
        modifiers &= ~Qt::ShiftModifier;
    }
    return QKeySequence(QKeyCombination(modifiers, static_cast<Qt::Key>(event.key())));
}

/// True for keys that navigate dialogs or hide the overlay, which no command may use without a modifier.
bool isReserved(const QKeySequence& key)
{
    static const std::array reserved{QKeySequence(Qt::Key_H),      QKeySequence(Qt::Key_Tab),
                                     QKeySequence(Qt::Key_Return), QKeySequence(Qt::Key_Enter),
                                     QKeySequence(Qt::Key_Up),     QKeySequence(Qt::Key_Down)};
    return std::ranges::find(reserved, key) != reserved.end();
}

QTreeWidgetItem* headingItem(const QString& text)
{
    auto* item = new QTreeWidgetItem({text});
    item->setFlags(Qt::ItemIsEnabled);
    QFont bold = item->font(0);
    bold.setWeight(QFont::DemiBold);
    item->setFont(0, bold);
    return item;
}

}   // namespace

KeySheet::KeySheet(std::vector<ShortcutRow> lines, QWidget* parent)
    : QDialog(parent), search_(new QLineEdit), list_(new QTreeWidget), status_(roleLabel("hint"))
{
    setObjectName(QStringLiteral("keySheet"));
    setWindowTitle(tr("Keyboard shortcuts"));
    setAttribute(Qt::WA_DeleteOnClose);
    search_->setPlaceholderText(tr("Search shortcuts and commands"));
    search_->setAccessibleName(tr("Search shortcuts"));
    search_->setClearButtonEnabled(true);
    list_->setColumnCount(2);
    list_->setHeaderHidden(true);
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setAccessibleName(tr("Shortcuts and their commands"));
    list_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    list_->installEventFilter(this);
    status_->setWordWrap(true);
    auto* reset = new QPushButton(tr("Reset all shortcuts"));
    auto* close = new QPushButton(tr("Close"));
    close->setProperty("role", "primary");
    for (QPushButton* button : {reset, close}) {
        button->setAutoDefault(false);
    }
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(reset);
    buttons->addStretch(1);
    buttons->addWidget(close);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(20, 18, 20, 16);
    layout->setSpacing(12);
    layout->addWidget(search_);
    layout->addWidget(list_, 1);
    layout->addWidget(status_);
    layout->addLayout(buttons);
    connect(search_, &QLineEdit::textChanged, this, &KeySheet::showMatching);
    connect(list_, &QTreeWidget::itemActivated, this, &KeySheet::startRecording);
    connect(reset, &QPushButton::clicked, this, &KeySheet::resetRequested);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    resizeWithinScreen(*this, {620, 700});
    showRows(std::move(lines));
    search_->setFocus();
}

void KeySheet::showRows(std::vector<ShortcutRow> lines)
{
    rows_ = std::move(lines);
    showMatching();
}

void KeySheet::showMatching()
{
    const int place = list_->indexOfTopLevelItem(list_->currentItem());
    list_->clear();
    QList<QTreeWidgetItem*> items;
    QList<QTreeWidgetItem*> headings;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const ShortcutRow& line = rows_[i];
        if (!matches(line, search_->text())) {
            continue;
        }
        if (headings.isEmpty() || line.heading != headings.back()->text(0)) {
            headings.append(headingItem(line.heading));
            items.append(headings.back());
        }
        items.append(new QTreeWidgetItem({line.keys, line.effect}));
        items.back()->setData(0, lineRole, static_cast<int>(i));
    }
    list_->addTopLevelItems(items);   // one call, since every addition would update the layout
    for (QTreeWidgetItem* heading : headings) {
        heading->setFirstColumnSpanned(true);
    }
    list_->setCurrentItem(list_->topLevelItem(std::max(0, place)));
    stopRecording(list_->topLevelItemCount() == 0 ? tr("No shortcut for “%1”.").arg(search_->text())
                                                  : tr("Double-click a command or press Enter to assign a shortcut."));
}

const ShortcutRow* KeySheet::rowOf(const QTreeWidgetItem* item) const
{
    const QVariant index = item ? item->data(0, lineRole) : QVariant();
    return index.isValid() ? &rows_[static_cast<std::size_t>(index.toInt())] : nullptr;
}

const ShortcutRow* KeySheet::conflictingRow(const QKeySequence& key) const
{
    const auto match = std::ranges::find_if(rows_, [&](const ShortcutRow& line) {
        return line.action && line.action != recordedAction_ && line.action->shortcuts().contains(key);
    });
    return match == rows_.end() ? nullptr : &*match;
}

void KeySheet::startRecording(QTreeWidgetItem* item)
{
    const ShortcutRow* line = rowOf(item);
    if (!line || !line->action) {
        stopRecording(line ? tr("This shortcut is fixed.") : QString());
        return;
    }
    recordedAction_ = line->action;
    warnedKey_ = {};
    setRole(status_, "attention");
    status_->setText(
        tr("Press the new shortcut for “%1”. Esc keeps the old shortcut; Delete removes it.").arg(line->effect));
}

void KeySheet::stopRecording(const QString& word)
{
    recordedAction_ = nullptr;
    setRole(status_, "hint");
    status_->setText(word);
}

bool KeySheet::eventFilter(QObject* watched, QEvent* event)
{
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (!recordedAction_ || !isKey) {
        return QDialog::eventFilter(watched, event);
    }
    event->accept();
    const auto* pressed = static_cast<QKeyEvent*>(event);
    if (event->type() == QEvent::ShortcutOverride || isModifier(pressed->key())) {
        return true;
    }
    if (pressed->key() == Qt::Key_Escape) {
        stopRecording(tr("The old shortcut is kept."));
    } else if (pressed->key() == Qt::Key_Delete) {
        take({});
    } else {
        take(keyOf(*pressed));
    }
    return true;
}

void KeySheet::take(const QKeySequence& key)
{
    const QString name = key.toString(QKeySequence::NativeText);
    if (isReserved(key)) {
        status_->setText(tr("“%1” is reserved. Press another key.").arg(name));
        return;
    }
    const ShortcutRow* owner = key.isEmpty() ? nullptr : conflictingRow(key);
    if (owner && warnedKey_ != key) {
        warnedKey_ = key;
        status_->setText(tr("“%1” is assigned to “%2”. Press it again to reassign it, or press another key.")
                             .arg(name, owner->effect));
        return;
    }
    QAction* action = std::exchange(recordedAction_, nullptr);
    emit keyChosen(action, key);
    stopRecording(key.isEmpty() ? tr("Shortcut removed.") : tr("The shortcut is now “%1”.").arg(name));
}

}   // namespace angiopose::ui

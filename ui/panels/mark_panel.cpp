#include "ui/panels/mark_panel.h"

#include "ui/actions/key_hint.h"
#include "ui/theme/active_theme.h"
#include "ui/words/retranslation.h"

#include <QAction>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QScopedValueRollback>
#include <QTreeWidget>

#include <algorithm>
#include <utility>

namespace angiopose::ui {
namespace {

constexpr int maxVisibleMarks = 6;
enum MarkColumn { MarkName, MarkValue, MarkColumnCount };
constexpr std::array markCommands{Command::TargetPoint, Command::OstiumRing, Command::TargetInImage, Command::DrawArrow,
                                  Command::WriteText};

QString markModeText(std::size_t mode)
{
    switch (mode) {
        case 0:
            return MarkPanel::tr("Target point");
        case 1:
            return MarkPanel::tr("Ostium ring");
        case 2:
            return MarkPanel::tr("Mark in image");
        case 3:
            return MarkPanel::tr("Arrow");
        default:
            return MarkPanel::tr("Text");
    }
}

QPushButton* markModeButton(std::size_t mode)
{
    auto* button = withText(new QPushButton, [mode] { return markModeText(mode); });
    withToolTip(button, [mode] { return withShortcut(markModeText(mode), markCommands[mode]); });
    button->setCheckable(true);
    return button;
}

}   // namespace

MarkPanel::MarkPanel(QWidget* parent)
    : Section(
          "marks", [] { return tr("Target points and marks"); }, Folding::Foldable, parent),
      list_(new QTreeWidget),
      basis_(roleLabel("hint")),
      modes_{markModeButton(0), markModeButton(1), markModeButton(2), markModeButton(3), markModeButton(4)},
      remove_(withText(new QPushButton, [] { return tr("Remove"); })),
      export_(withText(new QPushButton, [] { return tr("Table…"); }))
{
    withToolTip(remove_, [] { return tr("Removes the selected marks (Delete)"); });
    withToolTip(export_,
                [] { return tr("Writes all target points and ostium rings with their errors to a CSV file."); });
    remove_->setProperty("role", "quiet");
    basis_->setWordWrap(true);
    setUpList();
    auto* modes = new QGridLayout;
    modes->setSpacing(8);
    for (std::size_t mode = 0; mode < modes_.size(); ++mode) {
        const bool isOnVessels = mode < 2;
        const int row = isOnVessels ? 0 : 1;
        const int column = static_cast<int>(isOnVessels ? 3 * mode : 2 * (mode - 2));
        modes->addWidget(modes_[mode], row, column, 1, isOnVessels ? 3 : 2);
    }
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(remove_);
    buttons->addWidget(export_);
    contentLayout()->addLayout(modes);
    contentLayout()->addWidget(list_);
    contentLayout()->addWidget(basis_);
    contentLayout()->addLayout(buttons);
    setFolded(true);
    connectParts();
    showMarks({}, {});
}

void MarkPanel::setUpList()
{
    withAccessibleName(list_, [] { return tr("Marks"); });
    list_->setColumnCount(MarkColumnCount);
    list_->setHeaderHidden(true);
    list_->setRootIsDecorated(false);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    list_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(MarkName, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(MarkValue, QHeaderView::ResizeToContents);
    list_->installEventFilter(this);
}

void MarkPanel::connectParts()
{
    connect(remove_, &QPushButton::clicked, this, &MarkPanel::removeSelected);
    connect(export_, &QPushButton::clicked, this, &MarkPanel::exportRequested);
    connect(list_, &QTreeWidget::itemSelectionChanged, this, [this] {
        if (!isUpdating_) {
            showBasis();
            emit selectionChanged();
        }
    });
    connect(list_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
        if (!isUpdating_ && column == MarkName) {
            emit renamed(list_->indexOfTopLevelItem(item), item->text(MarkName));
        }
    });
}

void MarkPanel::bindMode(std::size_t mode, QAction& action)
{
    QPushButton* button = modes_[mode];
    connect(button, &QPushButton::clicked, &action, [&action](bool on) { action.setChecked(on); });
    connect(&action, &QAction::toggled, this, [this, button](bool on) {
        button->setChecked(on);
        if (on) {
            setFolded(false);
        }
    });
}

std::set<int> MarkPanel::selectedRows() const
{
    std::set<int> rowIndices;
    for (QTreeWidgetItem* item : list_->selectedItems()) {
        rowIndices.insert(list_->indexOfTopLevelItem(item));
    }
    return rowIndices;
}

void MarkPanel::choose(int index)
{
    list_->clearSelection();
    list_->setCurrentItem(list_->topLevelItem(index));
}

void MarkPanel::showMarks(const std::vector<MarkRow>& rows, const QString& note)
{
    const QScopedValueRollback quiet(isUpdating_, true);
    rows_ = rows;
    note_ = note;
    const auto count = static_cast<int>(rows.size());
    while (list_->topLevelItemCount() > count) {
        delete list_->takeTopLevelItem(list_->topLevelItemCount() - 1);
    }
    for (int index = 0; index < count; ++index) {
        QTreeWidgetItem* item = list_->topLevelItem(index);
        if (!item) {
            item = new QTreeWidgetItem(list_);
            item->setFlags(item->flags() | Qt::ItemIsEditable);
        }
        const MarkRow& row = rows[static_cast<std::size_t>(index)];
        item->setText(MarkName, row.name);
        item->setText(MarkValue, row.value);
        item->setTextAlignment(MarkValue, Qt::AlignRight | Qt::AlignVCenter);
        item->setForeground(MarkValue, toQColor(row.isDoubtful ? activePalette().attention : activePalette().text));
        for (int column = 0; column < MarkColumnCount; ++column) {
            item->setToolTip(column, row.basis);
        }
    }
    const int visible = std::min(count, maxVisibleMarks);
    list_->setVisible(visible > 0);
    list_->setFixedHeight(visible > 0 ? visible * list_->sizeHintForRow(0) + 4 : 0);
    setHint(count == 0 ? QString() : QString::number(count));
    showBasis();
}

/// Shows how the value of the selected mark was obtained; without a selection, shows the note.
void MarkPanel::showBasis()
{
    const std::set<int> rowIndices = selectedRows();
    const QString basis = rowIndices.size() == 1 ? rows_[static_cast<std::size_t>(*rowIndices.begin())].basis : note_;
    basis_->setText(basis);
    basis_->setVisible(!basis.isEmpty());
    remove_->setEnabled(!rowIndices.empty());
    export_->setEnabled(!rows_.empty());
}

void MarkPanel::removeSelected()
{
    if (const std::set<int> rowIndices = selectedRows(); !rowIndices.empty()) {
        emit removeRequested(rowIndices);
    }
}

void MarkPanel::changeEvent(QEvent* event)
{
    Section::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        showMarks(std::vector<MarkRow>(rows_), QString(note_));
    }
}

bool MarkPanel::eventFilter(QObject* watched, QEvent* event)
{
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (watched != list_ || !isKey) {
        return Section::eventFilter(watched, event);
    }
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (event->type() == QEvent::ShortcutOverride) {   // these keys apply to marks here, not to branches
        event->setAccepted(key == Qt::Key_Delete || key == Qt::Key_F2);
        return event->isAccepted();
    }
    if (key == Qt::Key_Delete) {
        removeSelected();
    }
    return key == Qt::Key_Delete;
}

}   // namespace angiopose::ui

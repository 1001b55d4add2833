#include "ui/panels/snapshot_panel.h"

#include "ui/actions/key_hint.h"
#include "ui/theme/active_theme.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"
#include "ui/words/terms.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTreeWidget>

#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr int snapshotIdRole = Qt::UserRole;
constexpr int snapshotDoubtRole = Qt::UserRole + 1;
constexpr int maxSnapshotRows = 8;

enum SnapshotColumn { SnapshotMark, SnapshotName, SnapshotMedian, SnapshotColumnCount };

QString toQt(const std::string& text)
{
    return QString::fromStdString(text);
}

QString toolTipOf(const core::PoseSnapshot& snapshot)
{
    QStringList lines{methodName(snapshot.method)};
    const QString time = shortTime(snapshot.time);
    if (!time.isEmpty() || !snapshot.author.empty()) {
        lines << QStringList{toQt(snapshot.author), time}.join(QStringLiteral("  "));
    }
    if (snapshot.metrics) {
        lines << SnapshotPanel::tr("median %1 mm, 95th percentile %2 mm, coverage %3 %")
                     .arg(numberText(snapshot.metrics->medianMm, 2))
                     .arg(numberText(snapshot.metrics->p95Mm, 2))
                     .arg(numberText(100.0 * snapshot.metrics->coverage, 0));
    }
    lines << SnapshotPanel::tr("frame %1").arg(snapshot.frame + 1) << toQt(snapshot.note);
    lines.removeAll(QString());
    return lines.join(QLatin1Char('\n'));
}

}   // namespace

SnapshotPanel::SnapshotPanel(QWidget* parent)
    : Section(
          "poses", [] { return tr("Poses"); }, Folding::Foldable, parent),
      list_(new QTreeWidget),
      empty_(withText(roleLabel("hint"),
                      [] {
                          return tr("%1 saves the pose; %2 toggles A/B. Each registration is listed here.")
                              .arg(keyOf(Command::TakeSnapshot), keyOf(Command::ToggleSnapshots));
                      })),
      compare_(withText(new QPushButton, [] { return tr("Compare…"); }))
{
    empty_->setWordWrap(true);
    setUpList();
    contentLayout()->addWidget(empty_);
    contentLayout()->addWidget(list_);
    contentLayout()->addLayout(makeButtons());
    connectList();
    showSnapshots({});
}

void SnapshotPanel::setUpList()
{
    withAccessibleName(list_, [] { return tr("Snapshots"); });
    list_->setColumnCount(SnapshotColumnCount);
    list_->setHeaderHidden(true);
    list_->setRootIsDecorated(true);
    list_->setIndentation(12);
    list_->setUniformRowHeights(true);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    list_->setEditTriggers(QAbstractItemView::EditKeyPressed);
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->header()->setStretchLastSection(false);
    list_->header()->setMinimumSectionSize(16);
    list_->header()->setSectionResizeMode(SnapshotName, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(SnapshotMark, QHeaderView::ResizeToContents);
    list_->header()->setSectionResizeMode(SnapshotMedian, QHeaderView::ResizeToContents);
    list_->installEventFilter(this);
}

QHBoxLayout* SnapshotPanel::makeButtons()
{
    auto* keep = withText(new QPushButton, [] { return withShortcut(tr("Save pose"), Command::TakeSnapshot); });
    withToolTip(keep, [] {
        return tooltipWithShortcut(tr("Saves this pose and its values as a named snapshot."), Command::TakeSnapshot);
    });
    withToolTip(compare_, [] {
        return tooltipWithShortcut(tr("Compares poses and methods in a table."), Command::ComparePoses);
    });
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(keep);
    buttons->addWidget(compare_);
    connect(keep, &QPushButton::clicked, this, &SnapshotPanel::snapshotRequested);
    connect(compare_, &QPushButton::clicked, this, &SnapshotPanel::compareRequested);
    return buttons;
}

void SnapshotPanel::connectList()
{
    connect(list_, &QTreeWidget::itemSelectionChanged, this, [this] {
        if (const auto ids = selectedIds(); !isUpdating_ && ids.size() == 1) {
            emit snapshotPicked(*ids.begin());
        }
    });
    connect(list_, &QTreeWidget::itemDoubleClicked, this, [this](const QTreeWidgetItem* item) {
        if (const int id = item->data(SnapshotName, snapshotIdRole).toInt(); id > 0) {
            emit restoreRequested(id);
        }
    });
    connect(list_, &QTreeWidget::itemChanged, this, [this](const QTreeWidgetItem* item, int column) {
        if (!isUpdating_ && column == SnapshotName) {
            emit renamed(item->data(SnapshotName, snapshotIdRole).toInt(), item->text(SnapshotName));
        }
    });
    connect(list_, &QTreeWidget::itemExpanded, this, &SnapshotPanel::fitHeight);
    connect(list_, &QTreeWidget::itemCollapsed, this, &SnapshotPanel::fitHeight);
    connect(list_, &QWidget::customContextMenuRequested, this, &SnapshotPanel::showContextMenu);
}

void SnapshotPanel::fillItem(QTreeWidgetItem& item, const core::PoseSnapshot& snapshot) const
{
    item.setData(SnapshotName, snapshotIdRole, snapshot.id);
    item.setText(SnapshotName, toQt(snapshot.name));
    item.setText(SnapshotMedian, snapshot.metrics ? numberText(snapshot.metrics->medianMm, 2) : QStringLiteral("–"));
    item.setTextAlignment(SnapshotMedian, Qt::AlignRight | Qt::AlignVCenter);
    item.setFlags(item.flags() | Qt::ItemIsEditable);
    for (int column = 0; column < SnapshotColumnCount; ++column) {
        item.setToolTip(column, toolTipOf(snapshot));
    }
    item.setData(SnapshotMedian, snapshotDoubtRole, snapshot.metrics && !snapshot.metrics->isTrustworthy);
}

void SnapshotPanel::addRuns(const std::vector<core::PoseSnapshot>& snapshots)
{
    const auto count = std::ranges::count(snapshots, core::SnapshotKind::Run, &core::PoseSnapshot::kind);
    if (count == 0) {
        return;
    }
    auto* group = new QTreeWidgetItem(list_, {QString(), tr("Registrations (%1)").arg(count), QString()});
    group->setFlags(Qt::ItemIsEnabled);
    std::for_each(snapshots.rbegin(), snapshots.rend(), [&](const core::PoseSnapshot& run) {   // newest first
        if (run.kind == core::SnapshotKind::Run) {
            fillItem(*new QTreeWidgetItem(group), run);
        }
    });
    group->setExpanded(areRunsExpanded_);
}

void SnapshotPanel::showSnapshots(const std::vector<core::PoseSnapshot>& snapshots)
{
    const QScopedValueRollback quiet(isUpdating_, true);
    const std::set<int> selected = selectedIds();
    list_->clear();
    for (const core::PoseSnapshot& snapshot : snapshots) {
        if (snapshot.kind == core::SnapshotKind::Saved) {
            fillItem(*new QTreeWidgetItem(list_), snapshot);
        }
    }
    addRuns(snapshots);
    for (const int id : selected) {
        if (QTreeWidgetItem* item = itemOf(id)) {
            item->setSelected(true);
        }
    }
    empty_->setVisible(snapshots.empty());
    list_->setVisible(!snapshots.empty());
    setHint(snapshots.empty() ? QString() : tr("median (mm) · %1: A ⇄ B").arg(keyOf(Command::ToggleSnapshots)));
    showMarks(marks_);
    fitHeight();
}

void SnapshotPanel::showMarks(const SnapshotMarks& marks)
{
    const QScopedValueRollback quiet(isUpdating_, true);
    marks_ = marks;
    for (QTreeWidgetItemIterator it(list_); *it; ++it) {
        const int id = (*it)->data(SnapshotName, snapshotIdRole).toInt();
        const QString mark = marks.a == id ? tr("A") : marks.b == id ? tr("B") : QString();
        (*it)->setText(SnapshotMark, marks.shown == id ? mark + QStringLiteral("●") : mark);
    }
    color();
}

/// Sets the colors of the items; called again when the theme changes.
void SnapshotPanel::color()
{
    const QScopedValueRollback quiet(isUpdating_, true);
    const Palette& colors = activePalette();
    for (QTreeWidgetItemIterator it(list_); *it; ++it) {
        QTreeWidgetItem& item = **it;
        const bool isGroup = item.childCount() > 0;
        const bool isDoubtful = item.data(SnapshotMedian, snapshotDoubtRole).toBool();
        item.setForeground(SnapshotName, toQColor(isGroup ? colors.label : colors.text));
        item.setForeground(SnapshotMedian, toQColor(isDoubtful ? colors.attention : colors.label));
        item.setForeground(SnapshotMark, toQColor(colors.accent));
    }
}

void SnapshotPanel::changeEvent(QEvent* event)
{
    Section::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        color();
    }
}

void SnapshotPanel::editName(int snapshotId)
{
    if (QTreeWidgetItem* item = itemOf(snapshotId)) {
        setFolded(false);
        list_->setCurrentItem(item, SnapshotName);
        list_->editItem(item, SnapshotName);
    }
}

QTreeWidgetItem* SnapshotPanel::itemOf(int snapshotId) const
{
    for (QTreeWidgetItemIterator it(list_); *it; ++it) {
        if ((*it)->data(SnapshotName, snapshotIdRole).toInt() == snapshotId) {
            return *it;
        }
    }
    return nullptr;
}

std::set<int> SnapshotPanel::selectedIds() const
{
    std::set<int> ids;
    for (const QTreeWidgetItem* item : list_->selectedItems()) {
        ids.insert(item->data(SnapshotName, snapshotIdRole).toInt());
    }
    return ids;
}

bool SnapshotPanel::eventFilter(QObject* watched, QEvent* event)
{
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (watched != list_ || !isKey) {
        return Section::eventFilter(watched, event);
    }
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (event->type() == QEvent::ShortcutOverride) {   // these keys apply to snapshots here, not to branches
        event->setAccepted(key == Qt::Key_Delete || key == Qt::Key_F2);
        return event->isAccepted();
    }
    const std::set<int> ids = selectedIds();
    if (key == Qt::Key_Delete && !ids.empty()) {
        emit removeRequested(ids);
        return true;
    }
    if ((key == Qt::Key_Return || key == Qt::Key_Enter) && ids.size() == 1) {
        emit restoreRequested(*ids.begin());
        return true;
    }
    return Section::eventFilter(watched, event);
}

void SnapshotPanel::showContextMenu(const QPoint& position)
{
    const QTreeWidgetItem* item = list_->itemAt(position);
    const int id = item ? item->data(SnapshotName, snapshotIdRole).toInt() : 0;
    if (id == 0) {
        return;
    }
    std::set<int> affected = selectedIds();
    if (!affected.contains(id)) {
        affected = {id};
    }
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Restore\tReturn"), this, [this, id] { emit restoreRequested(id); });
    menu->addAction(tr("Use as A"), this, [this, id] { emit markRequested(id, true); });
    menu->addAction(tr("Use as B"), this, [this, id] { emit markRequested(id, false); });
    menu->addSeparator();
    menu->addAction(tr("Rename\tF2"), this, [this, id] { editName(id); });
    menu->addAction(tr("Delete\tDel"), this, [this, affected] { emit removeRequested(affected); });
    menu->addSeparator();
    menu->addAction(tr("Compare…") + QLatin1Char('\t') + keyOf(Command::ComparePoses), this,
                    &SnapshotPanel::compareRequested);
    menu->popup(list_->viewport()->mapToGlobal(position));
}

void SnapshotPanel::fitHeight()
{
    if (!isUpdating_) {
        for (int i = 0; i < list_->topLevelItemCount(); ++i) {
            const QTreeWidgetItem* item = list_->topLevelItem(i);
            areRunsExpanded_ = item->childCount() > 0 ? item->isExpanded() : areRunsExpanded_;
        }
    }
    int rows = 0;
    for (QTreeWidgetItem* item = list_->topLevelItem(0); item; item = list_->itemBelow(item)) {
        ++rows;
    }
    const int rowHeight = std::max(list_->sizeHintForRow(0), list_->fontMetrics().height() + 6);
    list_->setFixedHeight(std::clamp(rows, 1, maxSnapshotRows) * rowHeight + 2);
}

}   // namespace angiopose::ui

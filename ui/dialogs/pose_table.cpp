#include "ui/dialogs/pose_table.h"

#include "core/registration/methods/method_info.h"
#include "ui/controls/screen_fit.h"
#include "ui/controls/section.h"
#include "ui/theme/active_theme.h"
#include "ui/words/number.h"
#include "ui/words/terms.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QStyledItemDelegate>
#include <QTreeWidget>

#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr int poseTableWidth = 1280;
constexpr int poseTableHeight = 560;
constexpr int poseIdRole = Qt::UserRole;
constexpr int orderRole = Qt::UserRole + 1;
constexpr int methodColumns = 4;
constexpr int poseRowSpacing = 10;

enum PoseColumn {
    PoseName,
    PoseMethod,
    PoseMedian,
    PoseP95,
    PoseCovered,
    PoseInPlane,
    PoseDepth,
    PoseTurn,
    PoseTime,
    PoseAuthor,
    PoseWhen,
    PoseNote,
    PoseColumnCount
};

/// Row that sorts by the numeric values behind the displayed text.
class Row : public QTreeWidgetItem {
public:
    using QTreeWidgetItem::QTreeWidgetItem;
    bool operator<(const QTreeWidgetItem& other) const override
    {
        const int column = treeWidget()->sortColumn();
        const QVariant mine = data(column, orderRole);
        const QVariant its = other.data(column, orderRole);
        return mine.isValid() && its.isValid() ? mine.toDouble() < its.toDouble() : QTreeWidgetItem::operator<(other);
    }
};

/// Delegate for columns that cannot be edited.
class ReadOnly : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QWidget* createEditor(QWidget*, const QStyleOptionViewItem&, const QModelIndex&) const override { return nullptr; }
};

void setNumber(QTreeWidgetItem& item, int column, std::optional<double> number, int decimals)
{
    item.setText(column, number ? numberText(*number, decimals) : QStringLiteral("–"));
    item.setData(column, orderRole, number.value_or(1e300));
    item.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
}

QPushButton* button(const QString& text, const QString& toolTip)
{
    auto* newButton = new QPushButton(text);
    newButton->setToolTip(toolTip);
    newButton->setAutoDefault(false);
    return newButton;
}

}   // namespace

PoseTable::PoseTable(QWidget* parent)
    : QDialog(parent),
      table_(new QTreeWidget),
      reference_(roleLabel("hint")),
      run_(button(tr("Run"), tr("Runs the selected methods one after another from the current pose."))),
      stop_(button(tr("Stop"), tr("Stops the running method and skips the rest; finished results are kept."))),
      progress_(new QProgressBar),
      status_(roleLabel("hint")),
      restore_(button(tr("Restore"), tr("Moves the vessels to this pose; can be undone."))),
      makeReference_(button(tr("Use as reference"), tr("Shows differences relative to this pose."))),
      remove_(button(tr("Delete"), tr("Deletes the snapshots; can be undone.")))
{
    setObjectName(QStringLiteral("poseTable"));
    setWindowTitle(tr("Compare poses"));
    setAttribute(Qt::WA_DeleteOnClose);
    resizeWithinScreen(*this, {poseTableWidth, poseTableHeight});
    table_->setAccessibleName(tr("Poses side by side"));
    table_->setRootIsDecorated(false);
    table_->setUniformRowHeights(true);
    table_->setAlternatingRowColors(true);
    table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    table_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    table_->setHeaderLabels({tr("Pose"), tr("Method"), tr("Median (mm)"), tr("P95 (mm)"), tr("Coverage (%)"),
                             tr("Δ in-plane (mm)"), tr("Δ depth (mm)"), tr("Δ rot. (°)"), tr("Time (ms)"), tr("Author"),
                             tr("Date"), tr("Note")});
    for (int column = PoseMedian; column <= PoseTime; ++column) {
        table_->headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
    table_->header()->setStretchLastSection(true);
    for (int column = 0; column < PoseColumnCount; ++column) {
        if (column != PoseName && column != PoseAuthor && column != PoseNote) {
            table_->setItemDelegateForColumn(column, new ReadOnly(table_));
        }
    }

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 16, 18, 14);
    layout->setSpacing(10);
    layout->addWidget(reference_);
    layout->addWidget(table_, 1);
    layout->addLayout(makeButtons());
    layout->addWidget(makeMethods());

    connect(table_, &QTreeWidget::itemSelectionChanged, this, [this] {
        updateButtons();
        if (const auto ids = selectedIds(); !isUpdating_ && ids.size() == 1) {
            emit snapshotPicked(*ids.begin());
        }
    });
    connect(table_, &QTreeWidget::itemChanged, this, [this](const QTreeWidgetItem* item, int column) {
        if (!isUpdating_) {
            reportEdit(*item, column);
        }
    });
    showIdle({});
}

QLayout* PoseTable::makeButtons()
{
    auto* exportTable = button(tr("Export CSV…"), tr("Writes the table to a CSV file, with the poses as matrices."));
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    for (QPushButton* each : {restore_, makeReference_, remove_}) {
        row->addWidget(each);
    }
    row->addStretch(1);
    row->addWidget(exportTable);
    connect(restore_, &QPushButton::clicked, this, [this] { emit restoreRequested(*selectedIds().begin()); });
    connect(makeReference_, &QPushButton::clicked, this, [this] { emit referenceRequested(*selectedIds().begin()); });
    connect(remove_, &QPushButton::clicked, this, [this] { emit removeRequested(selectedIds()); });
    connect(exportTable, &QPushButton::clicked, this, &PoseTable::exportRequested);
    return row;
}

QWidget* PoseTable::makeMethods()
{
    auto* section = new Section(
        "poseTable/methods", [] { return tr("Run several methods"); }, Folding::Foldable);
    section->setHint(tr("Results are added to the table; the case is unchanged"));
    section->layout()->setContentsMargins(0, 4, 0, 0);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(16);
    for (const core::MethodInfo& info : core::methodInfos()) {
        auto* box = new QCheckBox(methodName(std::string(info.id)));
        box->setProperty("method", QByteArray(info.id.data(), static_cast<qsizetype>(info.id.size())));
        box->setToolTip(QString::fromUtf8(info.summary.data(), static_cast<qsizetype>(info.summary.size())));
        const int index = static_cast<int>(methods_.size());
        grid->addWidget(box, index / methodColumns, index % methodColumns);
        methods_.push_back(box);
        connect(box, &QCheckBox::toggled, this, &PoseTable::updateButtons);
    }
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    run_->setProperty("role", "primary");
    progress_->setTextVisible(false);
    progress_->setMaximumHeight(6);
    progress_->setRange(0, 1000);
    row->addWidget(run_);
    row->addWidget(stop_);
    row->addWidget(progress_, 1);
    row->addWidget(status_, 2);
    section->contentLayout()->addLayout(grid);
    section->contentLayout()->addLayout(row);
    connect(run_, &QPushButton::clicked, this, [this] { emit runRequested(chosenMethods()); });
    connect(stop_, &QPushButton::clicked, this, &PoseTable::stopRequested);
    return section;
}

void PoseTable::fillRow(QTreeWidgetItem& item, const PoseRow& row, bool isReference)
{
    const core::PoseSnapshot& snapshot = row.snapshot;
    item.setData(PoseName, poseIdRole, snapshot.id);
    item.setSizeHint(PoseNote, {0, table_->fontMetrics().height() + poseRowSpacing});   // stretchable column
    item.setText(PoseName, snapshot.id == 0 ? tr("Current pose") : QString::fromStdString(snapshot.name));
    item.setText(PoseMethod, methodName(snapshot.method));
    const auto& metrics = snapshot.metrics;
    setNumber(item, PoseMedian, metrics ? std::optional(metrics->medianMm) : std::nullopt, 2);
    setNumber(item, PoseP95, metrics ? std::optional(metrics->p95Mm) : std::nullopt, 2);
    setNumber(item, PoseCovered, metrics ? std::optional(100.0 * metrics->coverage) : std::nullopt, 0);
    setNumber(item, PoseInPlane, row.difference.inPlaneMm, 2);
    setNumber(item, PoseDepth, row.difference.depthMm, 2);
    setNumber(item, PoseTurn, row.difference.rotationDeg, 2);
    setNumber(item, PoseTime, snapshot.runMs > 0.0 ? std::optional(snapshot.runMs) : std::nullopt,
              snapshot.runMs < 10.0 ? 1 : 0);
    item.setText(PoseAuthor, QString::fromStdString(snapshot.author));
    item.setText(PoseWhen, shortTime(snapshot.time));
    item.setText(PoseNote, QString::fromStdString(snapshot.note));
    if (metrics && !metrics->isTrustworthy) {
        item.setForeground(PoseMedian, toQColor(activePalette().attention));
        item.setToolTip(PoseMedian, tr("This registration is not reliable."));
    }
    if (isReference) {
        QFont strong = table_->font();
        strong.setWeight(QFont::DemiBold);
        item.setFont(PoseName, strong);
    }
    item.setFlags(snapshot.id > 0 ? item.flags() | Qt::ItemIsEditable : item.flags());
}

void PoseTable::showRows(const std::vector<PoseRow>& rows, int referenceId)
{
    const QScopedValueRollback quiet(isUpdating_, true);
    const std::set<int> selected = selectedIds();
    const bool isFirst = rows_.empty();
    rows_ = rows;
    table_->setSortingEnabled(false);
    table_->clear();
    for (const PoseRow& row : rows) {
        auto* item = new Row(table_);
        fillRow(*item, row, row.snapshot.id == referenceId);
        item->setSelected(selected.contains(row.snapshot.id));
        if (row.snapshot.id == referenceId) {
            reference_->setText(
                tr("Differences are relative to “%1”, about the center of the tree. Amber: not reliable.")
                    .arg(item->text(PoseName)));
        }
    }
    table_->header()->setSortIndicator(isFirst ? -1 : table_->header()->sortIndicatorSection(),
                                       table_->header()->sortIndicatorOrder());
    table_->setSortingEnabled(true);
    for (int column = 0; isFirst && column < PoseColumnCount; ++column) {
        table_->resizeColumnToContents(column);
    }
    updateButtons();
}

void PoseTable::showChosenMethods(const std::vector<std::string>& methodIds)
{
    for (QCheckBox* box : methods_) {
        const std::string id = box->property("method").toByteArray().toStdString();
        box->setChecked(std::ranges::find(methodIds, id) != methodIds.end());
    }
}

void PoseTable::showRun(const QString& what, double progress)
{
    running_ = true;
    status_->setText(what);
    progress_->setValue(static_cast<int>(1000.0 * progress));
    updateButtons();
}

void PoseTable::showIdle(const QString& statusText)
{
    running_ = false;
    status_->setText(statusText);
    updateButtons();
}

void PoseTable::updateButtons()
{
    const std::set<int> ids = selectedIds();
    restore_->setEnabled(ids.size() == 1 && !ids.contains(0));
    makeReference_->setEnabled(ids.size() == 1);
    remove_->setEnabled(!ids.empty() && !ids.contains(0));
    run_->setEnabled(!running_ && !chosenMethods().empty());
    stop_->setEnabled(running_);
    progress_->setVisible(running_);
}

void PoseTable::reportEdit(const QTreeWidgetItem& item, int column)
{
    const int id = item.data(PoseName, poseIdRole).toInt();
    const auto row = std::ranges::find(rows_, id, [](const PoseRow& each) { return each.snapshot.id; });
    if (row == rows_.end() || id == 0) {
        return;
    }
    core::PoseSnapshot edited = row->snapshot;
    edited.name = item.text(PoseName).trimmed().toStdString();
    edited.author = item.text(PoseAuthor).trimmed().toStdString();
    edited.note = item.text(PoseNote).trimmed().toStdString();
    if (column == PoseName || column == PoseAuthor || column == PoseNote) {
        emit textEdited(edited);
    }
}

std::set<int> PoseTable::selectedIds() const
{
    std::set<int> ids;
    for (const QTreeWidgetItem* item : table_->selectedItems()) {
        ids.insert(item->data(PoseName, poseIdRole).toInt());
    }
    return ids;
}

std::vector<std::string> PoseTable::chosenMethods() const
{
    std::vector<std::string> ids;
    for (const QCheckBox* box : methods_) {
        if (box->isChecked()) {
            ids.push_back(box->property("method").toByteArray().toStdString());
        }
    }
    return ids;
}

}   // namespace angiopose::ui

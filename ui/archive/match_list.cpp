#include "ui/archive/match_list.h"

#include "ui/theme/active_theme.h"

#include <QCollator>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>

#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr int matchKeyRole = Qt::UserRole;
constexpr int imagesRole = Qt::UserRole + 1;
constexpr int requestedRole = Qt::UserRole + 2;   ///< set once the series of the study are loaded or requested

enum MatchColumn { What, PatientId, Date, MatchModality, MatchDescription, MatchImages, MatchColumnCount };

/// Item that sorts numbers by value, also within text: series 9 comes before series 10.
class MatchItem : public QTreeWidgetItem {
public:
    using QTreeWidgetItem::QTreeWidgetItem;

    bool operator<(const QTreeWidgetItem& other) const override
    {
        const int column = treeWidget() ? treeWidget()->sortColumn() : 0;
        if (column == MatchImages) {
            return data(column, imagesRole).toInt() < other.data(column, imagesRole).toInt();
        }
        QCollator order;
        order.setNumericMode(true);
        return order.compare(text(column), other.text(column)) < 0;
    }
};

}   // namespace

MatchList::MatchList(QWidget* parent) : QTreeWidget(parent)
{
    setObjectName(QStringLiteral("archiveMatches"));
    setAccessibleName(tr("Studies and series in the PACS"));
    setHeaderLabels({tr("Patient"), tr("ID"), tr("Date"), tr("Modality"), tr("Description"), tr("Images")});
    headerItem()->setTextAlignment(MatchImages, Qt::AlignRight | Qt::AlignVCenter);
    setSelectionMode(ExtendedSelection);
    setIndentation(18);
    setAllColumnsShowFocus(true);
    setExpandsOnDoubleClick(false);
    setVerticalScrollMode(ScrollPerPixel);
    setSortingEnabled(true);
    sortByColumn(Date, Qt::DescendingOrder);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(MatchDescription, QHeaderView::Stretch);
    connect(this, &QTreeWidget::itemExpanded, this, &MatchList::requestSeries);
    connect(this, &QTreeWidget::itemSelectionChanged, this, &MatchList::choiceChanged);
    connect(this, &QTreeWidget::itemDoubleClicked, this, &MatchList::activate);
}

void MatchList::fill(QTreeWidgetItem& item, const MatchRow& row)
{
    item.setData(What, matchKeyRole, row.key);
    item.setText(What, row.what);
    item.setText(PatientId, row.patientId);
    item.setText(Date, row.date);
    item.setText(MatchModality, row.modality);
    item.setText(MatchDescription, row.description);
    item.setText(MatchImages, row.images > 0 ? QLocale().toString(row.images) : QString());
    item.setData(MatchImages, imagesRole, row.images);
    item.setTextAlignment(MatchImages, Qt::AlignRight | Qt::AlignVCenter);
    for (int column = 0; column < MatchColumnCount; ++column) {
        item.setToolTip(column, item.text(column));
    }
}

void MatchList::addPlaceholder(QTreeWidgetItem& study)
{
    auto* waiting = new QTreeWidgetItem(&study);
    waiting->setText(What, tr("Searching…"));
    waiting->setFlags(Qt::NoItemFlags);
}

void MatchList::showStudies(const std::vector<MatchRow>& studies)
{
    setSortingEnabled(false);
    clear();
    studies_.clear();
    for (const MatchRow& row : studies) {
        auto* item = new MatchItem(this);
        fill(*item, row);
        addPlaceholder(*item);
        studies_.insert(row.key, item);
    }
    setSortingEnabled(true);
    fitColumns();
    if (topLevelItemCount() > 0) {
        setCurrentItem(topLevelItem(0));
    }
    emit choiceChanged();
}

/// Limits the column widths of names and IDs to leave room for the description.
void MatchList::fitColumns()
{
    for (int column : {What, PatientId, Date, MatchModality, MatchImages}) {
        resizeColumnToContents(column);
    }
    setColumnWidth(What, std::min(columnWidth(What) + 12, width() / 4));
    setColumnWidth(PatientId, std::min(columnWidth(PatientId), width() / 7));
}

void MatchList::showSeries(const QString& studyKey, const std::vector<MatchRow>& series)
{
    QTreeWidgetItem* study = studies_.value(studyKey);
    if (!study) {
        return;
    }
    qDeleteAll(study->takeChildren());
    QList<QTreeWidgetItem*> items;
    for (const MatchRow& row : series) {
        auto* item = new MatchItem;
        fill(*item, row);
        items << item;
    }
    setSortingEnabled(false);
    study->addChildren(items);
    setSortingEnabled(true);
}

void MatchList::markSeriesUnloaded(const QString& studyKey)
{
    if (QTreeWidgetItem* study = studies_.value(studyKey)) {
        study->setExpanded(false);
        study->setData(What, requestedRole, false);
    }
}

void MatchList::requestSeries(QTreeWidgetItem* study)
{
    if (!study->parent() && !study->data(What, requestedRole).toBool()) {
        study->setData(What, requestedRole, true);
        emit seriesRequested(study->data(What, matchKeyRole).toString());
    }
}

std::vector<MatchList::Selection> MatchList::selection() const
{
    std::vector<Selection> all;
    for (const QTreeWidgetItem* item : selectedItems()) {
        const QString key = item->data(What, matchKeyRole).toString();
        if (const QTreeWidgetItem* study = item->parent()) {
            all.push_back({study->data(What, matchKeyRole).toString(), key});
        } else {
            all.push_back({key, {}});
        }
    }
    return all;
}

void MatchList::activate(QTreeWidgetItem* item)
{
    if (item->flags() & Qt::ItemIsSelectable) {
        emit retrieveRequested();
    }
}

void MatchList::keyPressEvent(QKeyEvent* event)
{
    const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (isReturn && !selectedItems().isEmpty()) {
        emit retrieveRequested();
    } else {
        QTreeWidget::keyPressEvent(event);
    }
}

void MatchList::setPlaceholderText(const QString& placeholder)
{
    placeholder_ = placeholder;
    viewport()->update();
}

void MatchList::paintEvent(QPaintEvent* event)
{
    QTreeWidget::paintEvent(event);
    if (topLevelItemCount() == 0) {
        QPainter painter(viewport());
        painter.setPen(toQColor(activePalette().label));
        painter.drawText(viewport()->rect().adjusted(40, 20, -40, -20), Qt::AlignCenter | Qt::TextWordWrap,
                         placeholder_);
    }
}

}   // namespace angiopose::ui

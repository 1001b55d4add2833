#include "ui/dialogs/study_list.h"

#include "ui/theme/active_theme.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <QPixmap>

#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr int keyRole = Qt::UserRole;
constexpr int studyOrderRole = Qt::UserRole + 1;
constexpr int wordsRole = Qt::UserRole + 2;
constexpr int thumbnailDelayMs = 60;   // rows that are visible for less time during scrolling need no thumbnail
constexpr int headingHeight = 30;

enum Column { Description, Number, Modality, Images, Size, Pace, BodyPart, ColumnCount };

/// Item that sorts numbers by value; patients and studies keep their order unless sorted by name.
class Item : public QTreeWidgetItem {
public:
    using QTreeWidgetItem::QTreeWidgetItem;

    bool operator<(const QTreeWidgetItem& other) const override
    {
        const int column = treeWidget() ? treeWidget()->sortColumn() : 0;
        const QVariant mine = data(column, studyOrderRole), its = other.data(column, studyOrderRole);
        if (mine.isValid() && its.isValid()) {
            return mine.toDouble() < its.toDouble();
        }
        return QString::localeAwareCompare(text(column), other.text(column)) < 0;
    }
};

/// Returns the image centered on a square tile, which is empty without an image.
QIcon thumbnailOf(const QImage& image, double ratio)
{
    const auto side = static_cast<int>(StudyList::thumbnailSize * ratio);
    QPixmap tile(side, side);
    tile.fill(toQColor(image.isNull() ? activePalette().line : activePalette().canvas));
    if (!image.isNull()) {
        QPainter painter(&tile);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        const QSize size = image.size().scaled(tile.size(), Qt::KeepAspectRatio);
        painter.drawImage(QRect(QPoint((side - size.width()) / 2, (side - size.height()) / 2), size), image);
    }
    tile.setDevicePixelRatio(ratio);
    QIcon icon(tile);
    icon.addPixmap(tile, QIcon::Selected);   // keeps the thumbnail untinted in selected rows
    return icon;
}

QString searchedText(const StudySeriesRow& row)
{
    return QStringList{row.modality, row.description, row.bodyPart}.join(u' ');
}

}   // namespace

StudyList::StudyList(QWidget* parent) : QTreeWidget(parent)
{
    setAccessibleName(tr("Patients, studies and series"));
    setHeaderLabels(
        {tr("Series"), tr("No."), tr("Modality"), tr("Images"), tr("Size"), tr("Spacing, rate"), tr("Body part")});
    setIconSize({thumbnailSize, thumbnailSize});
    setIndentation(18);
    setVerticalScrollMode(ScrollPerPixel);
    setSortingEnabled(true);
    header()->setSectionResizeMode(Description, QHeaderView::Stretch);
    header()->setStretchLastSection(false);
    sortByColumn(Number, Qt::AscendingOrder);
    thumbnailTimer_.setSingleShot(true);
    thumbnailTimer_.setInterval(thumbnailDelayMs);
    connect(&thumbnailTimer_, &QTimer::timeout, this, &StudyList::requestThumbnails);
    connect(this, &QTreeWidget::itemChanged, this, &StudyList::applyCheckState);
    connect(this, &QTreeWidget::itemDoubleClicked, this, &StudyList::activate);
    connect(this, &QTreeWidget::itemExpanded, this, [this] { thumbnailTimer_.start(); });
    connect(this, &QTreeWidget::itemCollapsed, this, [this] { thumbnailTimer_.start(); });
}

/// Returns the item with this key below `parent` (null for patients), and creates it if necessary.
QTreeWidgetItem* StudyList::itemFor(const QString& key, QTreeWidgetItem* parent, int place)
{
    QTreeWidgetItem*& item = items_[key];
    if (item && item->parent() != parent && parent) {
        parent->addChild(item->parent()->takeChild(item->parent()->indexOfChild(item)));
    }
    if (!item) {
        item = parent ? new Item(parent) : new Item(this);
        item->setData(Description, keyRole, key);
        item->setExpanded(true);
    }
    for (int column = 0; column < ColumnCount; ++column) {
        item->setData(column, studyOrderRole, place);
    }
    return item;
}

void StudyList::showRows(const std::vector<PatientRow>& patients)
{
    isFilling_ = true;
    setSortingEnabled(false);
    series_.clear();
    std::set<QString> currentKeys;
    const auto addHeading = [this, &currentKeys](const QString& key, const QString& words, QTreeWidgetItem* parent,
                                                 int place) {
        QTreeWidgetItem* item = itemFor(key, parent, place);
        item->setText(Description, words);
        item->setToolTip(Description, words);
        item->setFirstColumnSpanned(true);
        item->setSizeHint(Description, {0, headingHeight});
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
        currentKeys.insert(key);
        return item;
    };
    int place = 0;
    for (const PatientRow& patient : patients) {
        QTreeWidgetItem* patientItem = addHeading(patient.key, patient.words, nullptr, place++);
        QFont strong = font();
        strong.setBold(true);
        patientItem->setFont(Description, strong);
        for (const StudyRow& study : patient.studies) {
            QTreeWidgetItem* studyItem = addHeading(study.key, study.words, patientItem, place++);
            for (const StudySeriesRow& row : study.series) {
                QTreeWidgetItem* item = itemFor(row.key, studyItem, place++);
                fillSeries(*item, row);
                item->setData(Description, wordsRole, patient.words + u' ' + study.words + u' ' + searchedText(row));
                series_.insert(row.key, row);
                currentKeys.insert(row.key);
            }
        }
    }
    removeOthers(currentKeys);
    setSortingEnabled(true);
    isFilling_ = false;
    for (int column = Number; column < ColumnCount; ++column) {
        resizeColumnToContents(column);
    }
    if (!currentItem() && topLevelItemCount() > 0 && topLevelItem(0)->childCount() > 0) {
        setCurrentItem(topLevelItem(0)->child(0)->child(0));
    }
    showMatches();
    thumbnailTimer_.start();
    emit choiceChanged();
}

void StudyList::fillSeries(QTreeWidgetItem& item, const StudySeriesRow& row)
{
    const QStringList texts{row.description, row.number > 0 ? QString::number(row.number) : QString(),
                            row.modality,    row.imageCount > 0 ? QString::number(row.imageCount) : QString(),
                            row.size,        row.frameRate,
                            row.bodyPart};
    const bool isUsable = row.use != StudySeriesRow::Use::None;
    const QBrush tone(toQColor(isUsable ? activePalette().text : activePalette().hint));
    for (int column = 0; column < ColumnCount; ++column) {
        item.setText(column, texts[column]);
        item.setForeground(column, tone);
        item.setToolTip(column, row.notes.join(u'\n'));
        item.setData(column, studyOrderRole, {});
    }
    item.setData(Number, studyOrderRole, row.number);
    item.setData(Images, studyOrderRole, row.imageCount);
    item.setData(Pace, studyOrderRole, row.sortValue);
    for (const Column column : {Number, Images, Pace}) {
        item.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
    item.setIcon(Description, thumbnailOf(thumbnails_.value(row.key), devicePixelRatioF()));
    item.setSizeHint(Description, {0, thumbnailSize + 6});
    item.setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | (isUsable ? Qt::ItemIsUserCheckable : Qt::NoItemFlags));
    if (isUsable) {
        const bool isTicked = row.key == vessels_ || views_.contains(row.key);
        item.setCheckState(Description, isTicked ? Qt::Checked : Qt::Unchecked);
    }
}

/// Removes items that are no longer listed; the key of a series can change while more of its files are read.
void StudyList::removeOthers(const std::set<QString>& currentKeys)
{
    const QSignalBlocker quiet(this);   // rows are inconsistent until the caller emits choiceChanged
    for (const QString& key : items_.keys()) {
        QTreeWidgetItem* item = currentKeys.contains(key) ? nullptr : items_.value(key);
        if (item) {   // null if already deleted with its parent
            forget(*item);
            delete item;
        }
    }
}

/// Removes the item and its descendants from the index.
void StudyList::forget(const QTreeWidgetItem& item)
{
    for (int i = 0; i < item.childCount(); ++i) {
        forget(*item.child(i));
    }
    const QString key = item.data(Description, keyRole).toString();
    items_.remove(key);
    views_.erase(key);
    if (vessels_ == key) {
        vessels_.clear();
    }
}

void StudyList::showThumbnail(const QString& key, const QImage& image)
{
    thumbnails_.insert(key, image);
    if (QTreeWidgetItem* item = items_.value(key)) {
        isFilling_ = true;
        item->setIcon(Description, thumbnailOf(image, devicePixelRatioF()));
        isFilling_ = false;
    }
}

void StudyList::applyCheckState(QTreeWidgetItem* item, int column)
{
    const QString key = item->data(Description, keyRole).toString();
    if (isFilling_ || column != Description || !series_.contains(key)) {
        return;
    }
    const bool isTicked = item->checkState(Description) == Qt::Checked;
    if (series_[key].use == StudySeriesRow::Use::View) {
        if (isTicked) {
            views_.insert(key);
        } else {
            views_.erase(key);
        }
    } else if (isTicked) {
        QTreeWidgetItem* before = items_.value(vessels_);
        vessels_ = key;
        isFilling_ = true;
        if (before && before != item) {
            before->setCheckState(Description, Qt::Unchecked);
        }
        isFilling_ = false;
    } else if (vessels_ == key) {
        vessels_.clear();
    }
    emit choiceChanged();
}

void StudyList::choose(const QString& key)
{
    const StudySeriesRow* row = rowOf(key);
    if (row && row->use != StudySeriesRow::Use::None) {
        items_[key]->setCheckState(Description, Qt::Checked);
    }
}

void StudyList::activate(QTreeWidgetItem* item)
{
    const StudySeriesRow* row = item ? rowOf(item->data(Description, keyRole).toString()) : nullptr;
    if (row && row->use != StudySeriesRow::Use::None) {
        choose(row->key);
        emit openRequested();
    }
}

void StudyList::keyPressEvent(QKeyEvent* event)
{
    if (event->key() != Qt::Key_Return && event->key() != Qt::Key_Enter) {
        QTreeWidget::keyPressEvent(event);
    } else if (currentRow()) {
        activate(currentItem());
    } else if (currentItem()) {
        currentItem()->setExpanded(!currentItem()->isExpanded());
    }
}

QStringList StudyList::chosenViews() const
{
    QStringList views;
    for (QTreeWidgetItemIterator at(const_cast<StudyList*>(this)); *at; ++at) {
        const QString key = (*at)->data(Description, keyRole).toString();
        if (views_.contains(key)) {
            views << key;
        }
    }
    return views;
}

const StudySeriesRow* StudyList::rowOf(const QString& key) const
{
    const auto rowIt = series_.constFind(key);
    return rowIt == series_.constEnd() ? nullptr : &rowIt.value();
}

const StudySeriesRow* StudyList::currentRow() const
{
    return currentItem() ? rowOf(currentItem()->data(Description, keyRole).toString()) : nullptr;
}

void StudyList::search(const QString& words)
{
    searchTerms_ = words.split(u' ', Qt::SkipEmptyParts);
    showMatches();
    thumbnailTimer_.start();
}

/// Hides series that do not contain all search words, and parents without a visible series.
void StudyList::showMatches()
{
    const auto matches = [this](const QTreeWidgetItem& item) {
        const QString text = item.data(Description, wordsRole).toString();
        return std::ranges::all_of(searchTerms_,
                                   [&text](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
    };
    for (int p = 0; p < topLevelItemCount(); ++p) {
        bool isPatientSeen = false;
        for (int s = 0; s < topLevelItem(p)->childCount(); ++s) {
            QTreeWidgetItem* study = topLevelItem(p)->child(s);
            bool isStudySeen = false;
            for (int i = 0; i < study->childCount(); ++i) {
                const bool isSeen = matches(*study->child(i));
                study->child(i)->setHidden(!isSeen);
                isStudySeen = isStudySeen || isSeen;
            }
            study->setHidden(!isStudySeen);
            isPatientSeen = isPatientSeen || isStudySeen;
        }
        topLevelItem(p)->setHidden(!isPatientSeen);
    }
}

void StudyList::requestThumbnails()
{
    QStringList visibleKeys;
    for (QTreeWidgetItem* item = itemAt(0, 0); item; item = itemBelow(item)) {
        if (visualItemRect(item).top() > viewport()->height()) {
            break;
        }
        const QString key = item->data(Description, keyRole).toString();
        if (series_.contains(key) && !thumbnails_.contains(key)) {
            visibleKeys << key;
        }
    }
    emit thumbnailsRequested(visibleKeys);
}

void StudyList::resizeEvent(QResizeEvent* event)
{
    QTreeWidget::resizeEvent(event);
    thumbnailTimer_.start();
}

void StudyList::scrollContentsBy(int dx, int dy)
{
    QTreeWidget::scrollContentsBy(dx, dy);
    thumbnailTimer_.start();
}

}   // namespace angiopose::ui

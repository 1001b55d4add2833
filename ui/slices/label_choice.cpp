#include "ui/slices/label_choice.h"

#include "ui/controls/section.h"
#include "ui/theme/active_theme.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr int maxLabelRows = 10;   // maximum number of visible rows
constexpr int minRows = 3;
constexpr int filteredFrom = 9;   // the filter field is shown from this number of labels on
constexpr int rowPadding = 8;
constexpr int swatchPx = 10;
constexpr int labelRole = Qt::UserRole;

enum LabelColumn { LabelName, LabelVolume };

QIcon swatch(const Color& color, double devicePxPerPx)
{
    QPixmap pixmap(QSize(swatchPx, swatchPx) * devicePxPerPx);
    pixmap.setDevicePixelRatio(devicePxPerPx);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(toQColor(color));
    painter.drawRoundedRect(QRectF(0, 0, swatchPx, swatchPx), 2.0, 2.0);
    return pixmap;
}

QString volumeText(double volumeMl)
{
    return LabelChoice::tr("%1 ml").arg(numberText(volumeMl, volumeMl < 10.0 ? 2 : volumeMl < 100.0 ? 1 : 0));
}

QPushButton* link(const LocalizedText& text, const LocalizedText& tip)
{
    auto* button = withToolTip(withText(new QPushButton, text), tip);
    button->setProperty("role", "link");
    return button;
}

}   // namespace

QString textOf(const LabelRow& row)
{
    return row.name.isEmpty() ? LabelChoice::tr("Label %1").arg(row.label)
                              : QStringLiteral("%1  %2").arg(row.label).arg(row.name);
}

LabelChoice::LabelChoice(QWidget* parent)
    : QWidget(parent),
      all_(link([] { return tr("All"); }, [] { return tr("Selects all labels in the list"); })),
      none_(link([] { return tr("None"); }, [] { return tr("Deselects all labels in the list"); })),
      vessels_(
          link([] { return tr("Vessels"); }, [] { return tr("Selects the labels whose names indicate vessels"); })),
      filter_(new QLineEdit),
      list_(new QTreeWidget),
      totalLabel_(roleLabel("hint"))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(headRow());
    layout->addWidget(filter_);
    layout->addWidget(list_);
    layout->addWidget(totalLabel_);
    filter_->setClearButtonEnabled(true);
    withAccessibleName(filter_, [] { return tr("Find a label"); });
    withAccessibleName(list_, [] { return tr("Vessel labels"); });
    list_->setRootIsDecorated(false);
    list_->setIndentation(0);
    list_->setUniformRowHeights(true);
    list_->setHeaderHidden(true);
    list_->setColumnCount(2);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->header()->setMinimumSectionSize(1);
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(LabelName, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(LabelVolume, QHeaderView::ResizeToContents);
    connect(filter_, &QLineEdit::textChanged, this, &LabelChoice::filter);
    connect(list_, &QTreeWidget::itemChanged, this, &LabelChoice::readCheckStates);
    connect(list_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (item) {
            emit currentRowChanged(list_->indexOfTopLevelItem(item));
        }
    });
    totalLabel_->setWordWrap(true);
    showNothing();
    keepTranslated(this, [this] {
        filter_->setPlaceholderText(tr("Find a label"));
        updateTexts();
    });
}

QLayout* LabelChoice::headRow()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(0);
    row->addWidget(withText(roleLabel("label"), [] { return tr("Labels"); }), 1);
    row->addWidget(vessels_);
    row->addWidget(all_);
    row->addWidget(none_);
    connect(all_, &QPushButton::clicked, this, [this] { choose(true); });
    connect(none_, &QPushButton::clicked, this, [this] { choose(false); });
    connect(vessels_, &QPushButton::clicked, this, [this] { choose(std::nullopt); });
    return row;
}

void LabelChoice::showReading()
{
    isReading_ = true;
    problem_.clear();
    replaceRows({}, {});
    show();
}

void LabelChoice::showProblem(const QString& reason)
{
    isReading_ = false;
    problem_ = reason;
    replaceRows({}, {});
    show();
}

void LabelChoice::showNothing()
{
    replaceRows({}, {});
    hide();
}

void LabelChoice::showLabels(std::vector<LabelRow> rows, std::set<int> suggested)
{
    isReading_ = false;
    problem_.clear();
    replaceRows(std::move(rows), std::move(suggested));
    show();
}

void LabelChoice::replaceRows(std::vector<LabelRow> rows, std::set<int> suggested)
{
    rows_ = std::move(rows);
    suggested_ = std::move(suggested);
    vessels_->setVisible(!suggested_.empty());
    filter_->setVisible(rows_.size() >= filteredFrom);
    fill();
}

void LabelChoice::showChosenLabels(const std::set<int>& labels)
{
    chosenLabels_ = labels;
    applyCheckStates();
    scrollToFirstChecked();
}

/// Scrolls a long list to the first checked label, unless there is a current row.
void LabelChoice::scrollToFirstChecked()
{
    const auto first =
        std::ranges::find_if(rows_, [this](const LabelRow& row) { return chosenLabels_.contains(row.label); });
    if (first != rows_.end() && !list_->currentItem()) {
        list_->scrollToItem(list_->topLevelItem(static_cast<int>(first - rows_.begin())),
                            QAbstractItemView::PositionAtCenter);
    }
}

void LabelChoice::setRunning(bool running)
{
    list_->setEnabled(!running);
    for (QPushButton* button : {all_, none_, vessels_}) {
        button->setEnabled(!running);
    }
}

void LabelChoice::focusList()
{
    list_->setFocus(Qt::OtherFocusReason);
}

void LabelChoice::fill()
{
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (const LabelRow& row : rows_) {
        auto* item = new QTreeWidgetItem(list_);
        item->setData(LabelName, labelRole, row.label);
        item->setIcon(LabelName, swatch(row.color, devicePixelRatioF()));
        item->setTextAlignment(LabelVolume, Qt::AlignRight | Qt::AlignVCenter);
        item->setSizeHint(LabelName, {0, list_->fontMetrics().height() + rowPadding});
    }
    {
        const QSignalBlocker quietFilter(filter_);
        filter_->clear();
    }
    fitHeight();
    applyCheckStates();
}

void LabelChoice::fitHeight()
{
    const int rowHeight = list_->fontMetrics().height() + rowPadding;
    const int rows = std::clamp(static_cast<int>(rows_.size()), minRows, maxLabelRows);
    list_->setMinimumHeight(minRows * rowHeight);
    list_->setMaximumHeight(rows * rowHeight);
}

void LabelChoice::filter(const QString& text)
{
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const bool isWanted = textOf(rows_[i]).contains(text.trimmed(), Qt::CaseInsensitive);
        list_->topLevelItem(static_cast<int>(i))->setHidden(!isWanted);
    }
}

void LabelChoice::choose(std::optional<bool> ticked)
{
    std::set<int> selection = ticked ? chosenLabels_ : suggested_;
    for (int i = 0; ticked && i < list_->topLevelItemCount(); ++i) {
        const QTreeWidgetItem* item = list_->topLevelItem(i);
        const int label = item->data(LabelName, labelRole).toInt();
        if (item->isHidden()) {
            continue;
        }
        if (*ticked) {
            selection.insert(label);
        } else {
            selection.erase(label);
        }
    }
    if (selection != chosenLabels_) {
        showChosenLabels(selection);
        emit selectionEdited(chosenLabels_);
    }
}

void LabelChoice::readCheckStates()
{
    std::set<int> ticked;
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        const QTreeWidgetItem* item = list_->topLevelItem(i);
        if (item->checkState(LabelName) == Qt::Checked) {
            ticked.insert(item->data(LabelName, labelRole).toInt());
        }
    }
    if (ticked != chosenLabels_) {
        chosenLabels_ = std::move(ticked);
        updateTexts();
        emit selectionEdited(chosenLabels_);
    }
}

void LabelChoice::applyCheckStates()
{
    const QSignalBlocker quiet(list_);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        list_->topLevelItem(static_cast<int>(i))
            ->setCheckState(LabelName, chosenLabels_.contains(rows_[i].label) ? Qt::Checked : Qt::Unchecked);
    }
    list_->viewport()->update();   // repaints explicitly, since signals are blocked
    updateTexts();
}

void LabelChoice::updateTexts()
{
    const QSignalBlocker quiet(list_);
    double volumeMl = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const LabelRow& row = rows_[i];
        QTreeWidgetItem* item = list_->topLevelItem(static_cast<int>(i));
        item->setText(LabelName, textOf(row));
        item->setText(LabelVolume, volumeText(row.volumeMl));
        item->setToolTip(LabelName, textOf(row) + QStringLiteral(" · ") + volumeText(row.volumeMl));
        const bool isSelected = chosenLabels_.contains(row.label);
        volumeMl += isSelected ? row.volumeMl : 0.0;
        count += isSelected ? 1 : 0;
    }
    totalLabel_->setText(isReading_ ? tr("Reading the labels…")
                         : !problem_.isEmpty()
                             ? problem_
                             : tr("%1 of %2 selected, %3").arg(count).arg(rows_.size()).arg(volumeText(volumeMl)));
}

}   // namespace angiopose::ui

#include "ui/dialogs/series_chooser.h"

#include "ui/controls/screen_fit.h"
#include "ui/controls/section.h"
#include "ui/words/language.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace angiopose::ui {
namespace {

constexpr int chooserWidth = 860;
constexpr int chooserHeight = 420;
constexpr int seriesRowSpacing = 10;
constexpr int rowRole = Qt::UserRole;

enum SeriesColumn {
    SeriesDescription,
    SeriesModality,
    SeriesImages,
    SeriesSize,
    SeriesSpacing,
    SeriesDate,
    SeriesColumnCount
};

}   // namespace

SeriesChooser::SeriesChooser(const QString& folder, std::vector<SeriesRow> rows, QWidget* parent)
    : QDialog(parent),
      rows_(std::move(rows)),
      list_(new QTreeWidget),
      notes_(roleLabel("body", {})),
      open_(new QPushButton(tr("Open")))
{
    setObjectName(QStringLiteral("seriesChooser"));
    setWindowTitle(tr("Choose a series"));
    setAttribute(Qt::WA_DeleteOnClose);
    resizeWithinScreen(*this, {chooserWidth, chooserHeight});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(22, 20, 22, 16);
    layout->setSpacing(12);
    layout->addWidget(roleLabel("heading", tr("Which series?")));
    auto* where = roleLabel("body", tr("%1 contains %n series.", nullptr, static_cast<int>(rows_.size())).arg(folder));
    where->setWordWrap(true);
    layout->addWidget(where);
    layout->addWidget(list_, 1);
    notes_->setWordWrap(true);
    notes_->setTextFormat(Qt::PlainText);
    layout->addWidget(notes_);

    auto* buttons = new QHBoxLayout;
    auto* cancel = new QPushButton(tr("Cancel"));
    open_->setProperty("role", "primary");
    open_->setDefault(true);
    buttons->addStretch(1);
    buttons->addWidget(cancel);
    buttons->addWidget(open_);
    layout->addLayout(buttons);

    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(open_, &QPushButton::clicked, this, &SeriesChooser::choose);
    connect(list_, &QTreeWidget::itemActivated, this, &SeriesChooser::choose);
    connect(list_, &QTreeWidget::currentItemChanged, this, &SeriesChooser::showNotes);
    fill();
    list_->setFocus();
}

void SeriesChooser::fill()
{
    list_->setAccessibleName(tr("Series in the folder"));
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setHeaderLabels(
        {tr("Description"), tr("Modality"), tr("Images"), tr("Size"), tr("Spacing (mm)"), tr("Date")});
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const SeriesRow& row = rows_[i];
        auto* item = new QTreeWidgetItem(
            list_, {row.description, row.modality, QString::number(row.imageCount), row.size, row.spacingMm, row.date});
        item->setData(SeriesDescription, rowRole, static_cast<int>(i));
        item->setSizeHint(SeriesDate, {0, list_->fontMetrics().height() + seriesRowSpacing});   // stretchable column
        item->setTextAlignment(SeriesImages, Qt::AlignRight | Qt::AlignVCenter);
        item->setToolTip(SeriesDescription, row.notes.join(QLatin1Char('\n')));
        if (!row.isOpenable) {
            item->setForeground(SeriesDescription, palette().brush(QPalette::Disabled, QPalette::Text));
        }
    }
    for (int column = 0; column < SeriesColumnCount; ++column) {
        list_->resizeColumnToContents(column);
    }
    list_->header()->setStretchLastSection(true);
    list_->setCurrentItem(list_->topLevelItem(0));
    showNotes();
}

int SeriesChooser::currentRow() const
{
    const QTreeWidgetItem* item = list_->currentItem();
    return item ? item->data(SeriesDescription, rowRole).toInt() : -1;
}

void SeriesChooser::showNotes()
{
    const int row = currentRow();
    const bool hasRow = row >= 0 && static_cast<std::size_t>(row) < rows_.size();
    notes_->setText(hasRow ? joinSentences(rows_[static_cast<std::size_t>(row)].notes) : QString());
    open_->setEnabled(hasRow && rows_[static_cast<std::size_t>(row)].isOpenable);
}

void SeriesChooser::choose()
{
    const int row = currentRow();
    if (row < 0 || !rows_[static_cast<std::size_t>(row)].isOpenable) {
        return;
    }
    emit seriesChosen(rows_[static_cast<std::size_t>(row)].id);
    accept();
}

}   // namespace angiopose::ui

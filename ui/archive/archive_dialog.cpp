#include "ui/archive/archive_dialog.h"

#include "ui/archive/match_list.h"
#include "ui/archive/receive_line.h"
#include "ui/archive/search_fields.h"
#include "ui/archive/send_dialog.h"
#include "ui/archive/transfer_line.h"
#include "ui/controls/screen_fit.h"
#include "ui/controls/section.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace angiopose::ui {
namespace {

constexpr QSize archiveDialogSize(1080, 720);

}   // namespace

ArchiveDialog::ArchiveDialog(QWidget* parent)
    : QDialog(parent),
      nodes_(new NodeBar),
      fields_(new SearchFields),
      list_(new MatchList),
      transferStatus_(new TransferLine),
      cache_(new CacheLine),
      receive_(new ReceiveLine),
      partial_(new QPushButton(tr("Open retrieved"))),
      retrieve_(new QPushButton(tr("Retrieve")))
{
    setObjectName(QStringLiteral("archiveDialog"));
    setWindowTitle(tr("Query PACS"));
    setAttribute(Qt::WA_DeleteOnClose);
    resizeWithinScreen(*this, archiveDialogSize);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(22, 20, 22, 16);
    layout->setSpacing(12);
    layout->addWidget(nodes_);
    layout->addWidget(fields_);
    layout->addWidget(list_, 1);
    layout->addWidget(transferStatus_);
    layout->addWidget(receive_);
    layout->addLayout(makeButtons());
    connect(transferStatus_, &TransferLine::busyChanged, this, &ArchiveDialog::showState);
    connect(list_, &MatchList::choiceChanged, this, &ArchiveDialog::showState);
    connect(list_, &MatchList::retrieveRequested, retrieve_, &QPushButton::click);
    showState();
}

QLayout* ArchiveDialog::makeButtons()
{
    auto* close = new QPushButton(tr("Close"));
    partial_->setProperty("role", "link");
    partial_->setToolTip(tr("Select from the received objects"));
    partial_->hide();
    retrieve_->setProperty("role", "primary");
    retrieve_->setToolTip(
        tr("Retrieves the selected studies and series, from which you then choose the vessels and views"));
    auto* row = new QHBoxLayout;
    row->addWidget(cache_, 1);
    row->addWidget(partial_);
    row->addWidget(close);
    row->addWidget(retrieve_);
    for (QPushButton* button : {partial_, close, retrieve_}) {
        button->setAutoDefault(false);   // instead, Return in a field starts the search
    }
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(partial_, &QPushButton::clicked, this, &ArchiveDialog::partialSeriesRequested);
    connect(retrieve_, &QPushButton::clicked, this, &ArchiveDialog::retrieveRequested);
    return row;
}

void ArchiveDialog::showState()
{
    const bool isFree = !transferStatus_->isBusy();
    const bool hasNode = !nodes_->node().isEmpty();
    nodes_->setBusy(!isFree);
    cache_->setBusy(!isFree);
    fields_->setSearchEnabled(isFree && hasNode);
    retrieve_->setEnabled(isFree && hasNode && !list_->selectedItems().isEmpty());
    if (list_->topLevelItemCount() == 0 && !hasNode) {
        list_->setPlaceholderText(
            tr("No PACS configured. Add one (ask your PACS administrator for host, port and AE title)."));
    }
}

void ArchiveDialog::offerPartialSeries(bool isOffered)
{
    partial_->setVisible(isOffered);
}

}   // namespace angiopose::ui

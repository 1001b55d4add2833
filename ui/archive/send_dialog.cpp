#include "ui/archive/send_dialog.h"

#include "ui/archive/node_bar.h"
#include "ui/archive/transfer_line.h"
#include "ui/controls/section.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace angiopose::ui {
namespace {

constexpr int sendDialogWidth = 720;
constexpr int sendDialogHeight = 220;

}   // namespace

SendDialog::SendDialog(QWidget* parent)
    : QDialog(parent),
      nodes_(new NodeBar),
      line_(new TransferLine),
      close_(new QPushButton(tr("Close"))),
      send_(new QPushButton(tr("Send")))
{
    setObjectName(QStringLiteral("archiveSendDialog"));
    setWindowTitle(tr("Send to archive"));
    setAttribute(Qt::WA_DeleteOnClose);
    setMinimumSize(sendDialogWidth, sendDialogHeight);
    auto* hint =
        roleLabel("hint", tr("The objects are made once. Sending them again after a fault sends the same ones, "
                             "so that none is in the archive twice."));
    hint->setWordWrap(true);
    send_->setProperty("role", "primary");
    send_->setDefault(true);
    close_->setAutoDefault(false);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(close_);
    row->addWidget(send_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(22, 20, 22, 16);
    layout->setSpacing(12);
    layout->addWidget(nodes_);
    layout->addWidget(hint);
    layout->addStretch(1);
    layout->addWidget(line_);
    layout->addLayout(row);
    connect(line_, &TransferLine::busyChanged, this, &SendDialog::showState);
    connect(close_, &QPushButton::clicked, this, &QDialog::reject);
    connect(send_, &QPushButton::clicked, this, &SendDialog::sendRequested);
    showState();
}

void SendDialog::showState()
{
    const bool isFree = !line_->isBusy();
    const bool hasNode = !nodes_->node().isEmpty();
    nodes_->setBusy(!isFree);
    send_->setEnabled(isFree && hasNode);
}

void SendDialog::showNode()
{
    line_->showHint(nodes_->node().isEmpty()
                        ? tr("No archive is known yet. Add one: who runs it tells you host, port and AE title.")
                        : tr("The objects go to %1 when you send them.").arg(nodes_->node()));
    showState();
}

void SendDialog::showSent(const QString& words)
{
    line_->showDone(words);
    send_->setEnabled(false);
    close_->setFocus();
}

}   // namespace angiopose::ui

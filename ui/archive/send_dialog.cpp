#include "ui/archive/send_dialog.h"

#include "ui/archive/transfer_line.h"
#include "ui/controls/section.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr int sendDialogWidth = 720;
constexpr int sendDialogHeight = 220;

}   // namespace

NodeBar::NodeBar(QWidget* parent)
    : QWidget(parent),
      nodes_(new QComboBox),
      test_(new QPushButton(tr("Test connection"))),
      add_(new QPushButton(tr("Add…"))),
      edit_(new QPushButton(tr("Edit…"))),
      remove_(new QPushButton(tr("Remove…")))
{
    nodes_->setObjectName(QStringLiteral("archiveNodes"));
    nodes_->setAccessibleName(tr("PACS"));
    nodes_->setMinimumWidth(220);
    nodes_->setPlaceholderText(tr("No PACS yet"));
    test_->setToolTip(tr("Checks whether the PACS responds and accepts this program"));
    add_->setToolTip(tr("Adds a PACS to the list; the command line uses the same list"));
    edit_->setToolTip(tr("Edits host, port, AE titles and security"));
    remove_->setToolTip(tr("Removes the PACS from the list"));
    auto* label = roleLabel("label", tr("PACS"));
    label->setBuddy(nodes_);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(label);
    layout->addWidget(nodes_, 1);
    for (QPushButton* button : {test_, add_, edit_, remove_}) {
        button->setAutoDefault(false);
        layout->addWidget(button);
    }
    connect(nodes_, &QComboBox::activated, this, [this] { emit nodeChosen(node()); });
    connect(test_, &QPushButton::clicked, this, &NodeBar::testRequested);
    connect(add_, &QPushButton::clicked, this, &NodeBar::addRequested);
    connect(edit_, &QPushButton::clicked, this, &NodeBar::editRequested);
    connect(remove_, &QPushButton::clicked, this, &NodeBar::removeRequested);
    showState();
}

void NodeBar::showNodes(const QStringList& names, const QString& current)
{
    nodes_->clear();
    nodes_->addItems(names);
    nodes_->setCurrentIndex(names.isEmpty() ? -1 : std::max(0, static_cast<int>(names.indexOf(current))));
    showState();
    if (names.isEmpty()) {
        add_->setFocus();   // without a configured archive, Add is the only available action
    }
}

QString NodeBar::node() const
{
    return nodes_->currentText();
}

void NodeBar::setBusy(bool isBusy)
{
    isBusy_ = isBusy;
    showState();
}

void NodeBar::showState()
{
    const bool hasNode = nodes_->count() > 0;
    nodes_->setEnabled(hasNode && !isBusy_);
    test_->setEnabled(hasNode && !isBusy_);
    edit_->setEnabled(hasNode && !isBusy_);
    remove_->setEnabled(hasNode && !isBusy_);
    add_->setEnabled(!isBusy_);
}

SendDialog::SendDialog(QWidget* parent)
    : QDialog(parent),
      nodes_(new NodeBar),
      transferStatus_(new TransferLine),
      close_(new QPushButton(tr("Close"))),
      send_(new QPushButton(tr("Send")))
{
    setObjectName(QStringLiteral("archiveSendDialog"));
    setWindowTitle(tr("Send to PACS"));
    setAttribute(Qt::WA_DeleteOnClose);
    setMinimumSize(sendDialogWidth, sendDialogHeight);
    auto* hint = roleLabel("hint", tr("The objects are created once. Sending again after an error transfers the same "
                                      "objects, so none is stored twice."));
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
    layout->addWidget(transferStatus_);
    layout->addLayout(row);
    connect(transferStatus_, &TransferLine::busyChanged, this, &SendDialog::showState);
    connect(close_, &QPushButton::clicked, this, &QDialog::reject);
    connect(send_, &QPushButton::clicked, this, &SendDialog::sendRequested);
    showState();
}

void SendDialog::showState()
{
    const bool isFree = !transferStatus_->isBusy();
    const bool hasNode = !nodes_->node().isEmpty();
    nodes_->setBusy(!isFree);
    send_->setEnabled(isFree && hasNode);
}

void SendDialog::showNode()
{
    transferStatus_->showHint(
        nodes_->node().isEmpty()
            ? tr("No PACS configured. Add one (ask your PACS administrator for host, port and AE title).")
            : tr("The objects are sent to %1 when you click “Send”.").arg(nodes_->node()));
    showState();
}

void SendDialog::showSent(const QString& text)
{
    transferStatus_->showDone(text);
    send_->setEnabled(false);
    close_->setFocus();
}

}   // namespace angiopose::ui

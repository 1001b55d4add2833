#include "ui/archive/node_bar.h"

#include "ui/controls/section.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace angiopose::ui {

NodeBar::NodeBar(QWidget* parent)
    : QWidget(parent),
      nodes_(new QComboBox),
      test_(new QPushButton(tr("Test connection"))),
      add_(new QPushButton(tr("Add …"))),
      edit_(new QPushButton(tr("Edit …"))),
      remove_(new QPushButton(tr("Remove …")))
{
    nodes_->setObjectName(QStringLiteral("archiveNodes"));
    nodes_->setAccessibleName(tr("Archive"));
    nodes_->setMinimumWidth(220);
    nodes_->setPlaceholderText(tr("No archive yet"));
    test_->setToolTip(tr("Ask whether the archive answers and lets us in"));
    add_->setToolTip(tr("Add an archive to the list; the command line uses the same list"));
    edit_->setToolTip(tr("Host, port, titles, security"));
    remove_->setToolTip(tr("Take the archive from the list"));
    auto* label = roleLabel("label", tr("Archive"));
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

void NodeBar::showNodes(const QStringList& names, const QString& chosen)
{
    nodes_->clear();
    nodes_->addItems(names);
    nodes_->setCurrentIndex(names.isEmpty() ? -1 : std::max(0, static_cast<int>(names.indexOf(chosen))));
    showState();
    if (names.isEmpty()) {
        add_->setFocus();   // nothing else can be done yet
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

}   // namespace angiopose::ui

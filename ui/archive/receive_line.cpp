#include "ui/archive/receive_line.h"

#include "ui/controls/number_field.h"
#include "ui/controls/section.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>

namespace angiopose::ui {
namespace {

constexpr int maxTitleLetters = 16;   // maximum length of an AE title, PS3.5 §6.2

}   // namespace

ReceiveLine::ReceiveLine(QWidget* parent)
    : QWidget(parent),
      enabled_(new QCheckBox(tr("Receive on port"))),
      port_(new NumberField({1.0, 65535.0, 0, {}, 1.0})),
      title_(new QLineEdit),
      security_(new QPushButton(tr("Security…"))),
      label_(roleLabel("label")),
      open_(new QPushButton(tr("Show objects")))
{
    enabled_->setObjectName(QStringLiteral("receiveSwitch"));
    enabled_->setToolTip(
        tr("Accepts objects sent to this computer by modalities and PACS until receiving is turned off or the window "
           "is closed"));
    port_->setObjectName(QStringLiteral("receivePort"));
    port_->setAccessibleName(tr("Receiving port"));
    port_->setFixedWidth(90);
    title_->setObjectName(QStringLiteral("receiveTitle"));
    title_->setAccessibleName(tr("Receiving AE title"));
    title_->setToolTip(tr("Calling applications must use this called AE title"));
    title_->setMaxLength(maxTitleLetters);
    title_->setFixedWidth(170);
    security_->setObjectName(QStringLiteral("receiveSecurity"));
    security_->setAutoDefault(false);
    security_->setToolTip(tr("Sets which applications may connect to this port, and encryption (TLS)"));
    label_->setObjectName(QStringLiteral("receiveWords"));
    label_->setTextFormat(Qt::PlainText);   // calling AE titles come from the network, so no rich text
    label_->setWordWrap(true);
    open_->setAutoDefault(false);
    open_->setToolTip(tr("Select from the received objects"));
    open_->hide();
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(enabled_);
    layout->addWidget(port_);
    layout->addWidget(roleLabel("label", tr("as AE title")));
    layout->addWidget(title_);
    layout->addWidget(security_);
    layout->addWidget(label_, 1);
    layout->addWidget(open_);
    connect(enabled_, &QCheckBox::clicked, this, &ReceiveLine::toggled);
    connect(security_, &QPushButton::clicked, this, &ReceiveLine::securityRequested);
    connect(open_, &QPushButton::clicked, this, &ReceiveLine::openRequested);
}

void ReceiveLine::showPort(int port, const QString& title)
{
    port_->showValue(port);
    title_->setText(title);
}

void ReceiveLine::showListening(bool isListening)
{
    const QSignalBlocker silent(enabled_);
    enabled_->setChecked(isListening);
    port_->setEnabled(!isListening);
    title_->setEnabled(!isListening);
    security_->setEnabled(!isListening);
}

void ReceiveLine::showReceived(const QString& statusText, bool canOpen)
{
    label_->setText(statusText);
    open_->setVisible(canOpen);
}

int ReceiveLine::port() const
{
    return static_cast<int>(port_->value().value_or(0.0));
}

QString ReceiveLine::title() const
{
    return title_->text().trimmed();
}

CacheLine::CacheLine(QWidget* parent)
    : QWidget(parent),
      size_(roleLabel("label")),
      limit_(new NumberField({0.1, 100000.0, 1, QStringLiteral("GB"), 1.0})),
      empty_(new QPushButton(tr("Empty…")))
{
    size_->setObjectName(QStringLiteral("cacheSize"));
    limit_->setObjectName(QStringLiteral("cacheLimit"));
    limit_->setAccessibleName(tr("Maximum cache size"));
    limit_->setToolTip(tr("The least recently used objects are deleted first"));
    limit_->setFixedWidth(110);
    empty_->setAutoDefault(false);
    empty_->setToolTip(tr("Deletes all retrieved objects"));
    auto* label = roleLabel("label", tr("of max."));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(size_);
    layout->addWidget(label);
    layout->addWidget(limit_);
    layout->addWidget(empty_);
    layout->addStretch(1);
    connect(limit_, &NumberField::edited, this, &CacheLine::limitChosen);
    connect(empty_, &QPushButton::clicked, this, &CacheLine::emptyRequested);
}

void CacheLine::showCache(const QString& size, bool isEmpty, double limitGb, const QString& folder)
{
    isEmpty_ = isEmpty;
    size_->setText(tr("Cache: %1").arg(size));
    size_->setToolTip(folder);
    limit_->showValue(limitGb);
    setBusy(false);
}

void CacheLine::setBusy(bool isBusy)
{
    empty_->setEnabled(!isBusy && !isEmpty_);
    limit_->setEnabled(!isBusy);
}

}   // namespace angiopose::ui

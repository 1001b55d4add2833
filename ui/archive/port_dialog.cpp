#include "ui/archive/port_dialog.h"

#include "ui/archive/node_dialog.h"
#include "ui/archive/transfer_line.h"
#include "ui/controls/section.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace angiopose::ui {
namespace {

constexpr int portFieldWidth = 400;

void addPortRow(QFormLayout& form, const QString& name, QWidget* field, const QString& tip)
{
    auto* label = roleLabel("label", name);
    label->setBuddy(field);
    field->setAccessibleName(name);
    field->setToolTip(tip);
    form.addRow(label, field);
}

}   // namespace

PortDialog::PortDialog(const ScpSettings& entry, QWidget* parent)
    : QDialog(parent),
      titles_(new QLineEdit),
      hosts_(new QLineEdit),
      isTls_(new QCheckBox(tr("Encrypted (TLS)"))),
      certificate_(new PathField(tr("Local certificate (PEM)"))),
      key_(new PathField(tr("Private key of the local certificate (PEM)"))),
      ca_(new PathField(tr("Trusted certificates (PEM)"))),
      transferStatus_(new TransferLine)
{
    setObjectName(QStringLiteral("archivePortDialog"));
    setWindowTitle(tr("Security of the receiving port"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(22, 20, 22, 16);
    layout->setSpacing(10);
    layout->addLayout(makeForm());
    layout->addWidget(transferStatus_);
    layout->addLayout(makeButtons());
    connect(isTls_, &QCheckBox::toggled, this, &PortDialog::showState);
    fill(entry);
    transferStatus_->showHint(
        tr("With TLS, both the calling application and this program must present a valid certificate."));
}

QFormLayout* PortDialog::makeForm()
{
    titles_->setObjectName(QStringLiteral("portTitles"));
    hosts_->setObjectName(QStringLiteral("portHosts"));
    isTls_->setObjectName(QStringLiteral("portTls"));
    certificate_->line().setObjectName(QStringLiteral("portCertificate"));
    key_->line().setObjectName(QStringLiteral("portKey"));
    ca_->line().setObjectName(QStringLiteral("portTrusted"));
    titles_->setPlaceholderText(tr("anyone"));
    hosts_->setPlaceholderText(tr("anyone"));
    titles_->setMinimumWidth(portFieldWidth);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(14);
    form->setVerticalSpacing(10);
    addPortRow(*form, tr("Allowed calling AE titles"), titles_, tr("Comma-separated; leave empty to allow any"));
    addPortRow(*form, tr("Allowed addresses"), hosts_,
               tr("Comma-separated IP addresses, such as 10.0.0.7; leave empty to allow any"));
    form->addRow(QString(), isTls_);
    addPortRow(*form, tr("Local certificate"), certificate_, tr("PEM file presented to calling applications"));
    addPortRow(*form, tr("Private key"), key_, tr("PEM file; only its path is stored"));
    addPortRow(*form, tr("Trusted certificates"), ca_,
               tr("PEM file used to verify the certificates of calling applications; if empty, the certificates "
                  "trusted by the system are used"));
    return form;
}

QLayout* PortDialog::makeButtons()
{
    auto* cancel = new QPushButton(tr("Cancel"));
    auto* save = new QPushButton(tr("Save"));
    save->setProperty("role", "primary");
    save->setDefault(true);
    cancel->setAutoDefault(false);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(cancel);
    row->addWidget(save);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(save, &QPushButton::clicked, this, [this] { emit saveRequested(entry()); });
    return row;
}

void PortDialog::fill(const ScpSettings& entry)
{
    titles_->setText(entry.titles);
    hosts_->setText(entry.hosts);
    isTls_->setChecked(entry.isTls);
    certificate_->setPath(entry.certificateFile);
    key_->setPath(entry.keyFile);
    ca_->setPath(entry.caFile);
    showState();
}

void PortDialog::showState()
{
    for (PathField* field : {certificate_, key_, ca_}) {
        field->setEnabled(isTls_->isChecked());
    }
}

ScpSettings PortDialog::entry() const
{
    return {titles_->text().trimmed(), hosts_->text().trimmed(),
            isTls_->isChecked(),       ca_->path(),
            certificate_->path(),      key_->path()};
}

}   // namespace angiopose::ui

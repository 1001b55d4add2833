#include "ui/archive/node_dialog.h"

#include "ui/archive/transfer_line.h"
#include "ui/controls/number_field.h"
#include "ui/controls/section.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr int maxAeLetters = 16;
constexpr int maxNameLetters = 64;
constexpr int nodeFieldWidth = 400;

/// Gives the labels of all forms in the dialog the same width, so that their fields are aligned.
void alignNames(const QDialog& dialog)
{
    int widest = 0;
    for (const QLabel* label : dialog.findChildren<QLabel*>()) {
        widest = label->buddy() ? std::max(widest, label->sizeHint().width()) : widest;
    }
    for (QLabel* label : dialog.findChildren<QLabel*>()) {
        if (label->buddy()) {
            label->setMinimumWidth(widest);
        }
    }
}

}   // namespace

PathField::PathField(const QString& name, QWidget* parent) : QWidget(parent), name_(name), line_(new QLineEdit)
{
    auto* choose = new QPushButton(QStringLiteral("…"));
    choose->setAutoDefault(false);
    choose->setToolTip(tr("Choose a file"));
    choose->setAccessibleName(tr("Choose a file: %1").arg(name));
    line_->setAccessibleName(name);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(line_, 1);
    layout->addWidget(choose);
    setFocusProxy(line_);
    connect(choose, &QPushButton::clicked, this, &PathField::choose);
}

void PathField::setPath(const QString& path)
{
    line_->setText(path);
}

QString PathField::path() const
{
    return line_->text().trimmed();
}

void PathField::choose()
{
    auto* dialog = new QFileDialog(this, name_, QFileInfo(path()).absolutePath());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &PathField::setPath);
    dialog->open();
}

NodeDialog::NodeDialog(const ArchiveEntry& entry, Purpose purpose, QWidget* parent)
    : QDialog(parent),
      name_(new QLineEdit),
      host_(new QLineEdit),
      port_(new NumberField({1.0, 65535.0, 0, {}, 1.0})),
      title_(new QLineEdit),
      ownTitle_(new QLineEdit),
      webUrl_(new QLineEdit),
      authorization_(new PathField(tr("Authorization file"))),
      isTls_(new QCheckBox(tr("Encrypted (TLS)"))),
      ca_(new PathField(tr("CA certificates (PEM)"))),
      certificate_(new PathField(tr("Local certificate (PEM)"))),
      key_(new PathField(tr("Private key of the local certificate (PEM)"))),
      checksHost_(new QCheckBox(tr("Verify host name in certificate"))),
      receivePort_(new NumberField({0.0, 65535.0, 0, {}, 1.0})),
      answerSeconds_(new NumberField({1.0, 600.0, 0, QStringLiteral("s"), 1.0})),
      more_(new QPushButton(tr("Security, DICOMweb and more"))),
      line_(new TransferLine),
      test_(new QPushButton(tr("Test connection")))
{
    setObjectName(QStringLiteral("archiveNodeDialog"));
    setWindowTitle(purpose == Purpose::Add ? tr("Add PACS") : tr("Edit PACS"));
    setAttribute(Qt::WA_DeleteOnClose);
    advanced_ = makeAdvancedFields();
    more_->setProperty("role", "link");
    more_->setCheckable(true);
    more_->setAutoDefault(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(22, 20, 22, 16);
    layout->setSpacing(10);
    layout->setSizeConstraint(QLayout::SetMinAndMaxSize);
    layout->addLayout(makeAddress());
    layout->addWidget(more_, 0, Qt::AlignLeft);
    layout->addWidget(advanced_);
    layout->addWidget(line_);
    layout->addLayout(makeButtons(purpose));
    connect(more_, &QPushButton::toggled, advanced_, &QWidget::setVisible);
    connect(line_, &TransferLine::busyChanged, test_, &QWidget::setDisabled);
    alignNames(*this);
    fill(entry);
    line_->showHint(
        tr("Ask your PACS administrator for these values, and have the calling AE title registered in the PACS."));
}

void NodeDialog::addRow(QFormLayout& form, const QString& name, QWidget* field, const QString& tip)
{
    auto* label = roleLabel("label", name);
    label->setBuddy(field);
    field->setAccessibleName(name);
    field->setToolTip(tip);
    form.addRow(label, field);
}

QFormLayout* NodeDialog::makeAddress()
{
    name_->setObjectName(QStringLiteral("nodeName"));
    host_->setObjectName(QStringLiteral("nodeHost"));
    port_->setObjectName(QStringLiteral("nodePort"));
    title_->setObjectName(QStringLiteral("nodeTitle"));
    name_->setMaxLength(maxNameLetters);
    title_->setMaxLength(maxAeLetters);
    ownTitle_->setMaxLength(maxAeLetters);
    name_->setPlaceholderText(tr("Radiology PACS"));
    host_->setPlaceholderText(QStringLiteral("pacs.example.org"));
    host_->setMinimumWidth(nodeFieldWidth);
    port_->setFixedWidth(90);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(14);
    form->setVerticalSpacing(10);
    addRow(*form, tr("Name"), name_, tr("Name shown in this program"));
    addRow(*form, tr("Host"), host_, tr("Host name or IP address; leave empty if only DICOMweb is used"));
    addRow(*form, tr("Port"), port_, tr("Usually 104 or 11112"));
    addRow(*form, tr("Called AE title"), title_, tr("AE title of the PACS"));
    addRow(*form, tr("Calling AE title"), ownTitle_, tr("AE title under which the PACS knows this program"));
    return form;
}

QWidget* NodeDialog::makeAdvancedFields()
{
    auto* further = new QWidget;
    auto* form = new QFormLayout(further);
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(14);
    form->setVerticalSpacing(10);
    webUrl_->setPlaceholderText(QStringLiteral("https://pacs.example.org/dicom-web"));
    receivePort_->setFixedWidth(90);
    answerSeconds_->setFixedWidth(90);
    form->addRow(QString(), isTls_);
    addRow(*form, tr("CA certificates"), ca_, tr("PEM file; if empty, the CAs trusted by the system are used"));
    addRow(*form, tr("Local certificate"), certificate_, tr("PEM file (optional)"));
    addRow(*form, tr("Private key"), key_, tr("PEM file; only its path is stored"));
    form->addRow(QString(), checksHost_);
    addRow(*form, tr("DICOMweb address"), webUrl_, tr("Used if no host is specified"));
    addRow(*form, tr("Authorization"), authorization_,
           tr("File whose first line is sent as the Authorization header; only its path is stored"));
    addRow(*form, tr("Port for C-MOVE"), receivePort_,
           tr("Local port to which the PACS sends images if it does not support C-GET. 0: not used"));
    addRow(*form, tr("Response timeout"), answerSeconds_, tr("After this time, the PACS is considered unreachable"));
    further->hide();
    return further;
}

QLayout* NodeDialog::makeButtons(Purpose purpose)
{
    auto* cancel = new QPushButton(tr("Cancel"));
    auto* save = new QPushButton(purpose == Purpose::Add ? tr("Add") : tr("Save"));
    save->setProperty("role", "primary");
    save->setDefault(true);
    for (QPushButton* button : {test_, cancel}) {
        button->setAutoDefault(false);
    }
    auto* row = new QHBoxLayout;
    row->addWidget(test_);
    row->addStretch(1);
    row->addWidget(cancel);
    row->addWidget(save);
    connect(test_, &QPushButton::clicked, this, [this] { emit testRequested(entry()); });
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(save, &QPushButton::clicked, this, [this] { emit saveRequested(entry()); });
    return row;
}

void NodeDialog::fill(const ArchiveEntry& entry)
{
    name_->setText(entry.name);
    host_->setText(entry.host);
    port_->showValue(entry.port);
    title_->setText(entry.title);
    ownTitle_->setText(entry.ownAeTitle);
    webUrl_->setText(entry.webUrl);
    authorization_->setPath(entry.authorizationFile);
    isTls_->setChecked(entry.isTls);
    ca_->setPath(entry.caFile);
    certificate_->setPath(entry.certificateFile);
    key_->setPath(entry.keyFile);
    checksHost_->setChecked(entry.verifiesHost);
    receivePort_->showValue(entry.receivePort);
    answerSeconds_->showValue(entry.responseTimeoutSeconds);
    const bool isPlain = !entry.isTls && entry.webUrl.isEmpty() && entry.receivePort == 0;
    more_->setChecked(!isPlain);
    advanced_->setVisible(!isPlain);
}

ArchiveEntry NodeDialog::entry() const
{
    ArchiveEntry entry;
    entry.name = name_->text().trimmed();
    entry.host = host_->text().trimmed();
    entry.port = static_cast<int>(port_->value().value_or(0.0));
    entry.title = title_->text().trimmed();
    entry.ownAeTitle = ownTitle_->text().trimmed();
    entry.webUrl = webUrl_->text().trimmed();
    entry.authorizationFile = authorization_->path();
    entry.isTls = isTls_->isChecked();
    entry.caFile = ca_->path();
    entry.certificateFile = certificate_->path();
    entry.keyFile = key_->path();
    entry.verifiesHost = checksHost_->isChecked();
    entry.receivePort = static_cast<int>(receivePort_->value().value_or(0.0));
    entry.responseTimeoutSeconds = static_cast<int>(answerSeconds_->value().value_or(0.0));
    return entry;
}

}   // namespace angiopose::ui

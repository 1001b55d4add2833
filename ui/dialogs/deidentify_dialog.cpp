#include "ui/dialogs/deidentify_dialog.h"

#include "ui/controls/section.h"
#include "ui/dialogs/dialog_buttons.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

namespace angiopose::ui {
namespace {

constexpr int inputListHeight = 130;

}   // namespace

PackDialog::PackDialog(QWidget* parent)
    : QDialog(parent),
      deidentify_(new QCheckBox(tr("De-identify"))),
      shiftedDates_(new QCheckBox(tr("Shift dates instead of removing them"))),
      maskText_(new QCheckBox(tr("Mask burned-in text"))),
      pseudonym_(new QLineEdit)
{
    setObjectName(QStringLiteral("packDialog"));
    setWindowTitle(tr("Share case as ZIP"));
    setAttribute(Qt::WA_DeleteOnClose);
    setMinimumWidth(460);
    deidentify_->setChecked(true);
    maskText_->setChecked(true);
    pseudonym_->setPlaceholderText(tr("automatic"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(22, 20, 22, 16);
    layout->setSpacing(10);
    for (QCheckBox* box : {deidentify_, shiftedDates_, maskText_}) {
        layout->addWidget(box);
    }
    auto* form = new QFormLayout;
    form->addRow(tr("Pseudonym"), pseudonym_);
    layout->addLayout(form);
    auto* hint = roleLabel("hint", tr("Creates one archive with the case, its inputs and its results. "
                                      "De-identification removes names, IDs, dates, private elements and notes, and "
                                      "replaces UIDs. Branch names are kept. Review every image before sharing."));
    hint->setWordWrap(true);
    layout->addWidget(hint);
    auto* pack = new QPushButton(tr("Pack…"));
    layout->addLayout(dialogButtons(*this, tr("Cancel"), *pack));
    for (QWidget* further : std::initializer_list<QWidget*>{shiftedDates_, maskText_, pseudonym_}) {
        connect(deidentify_, &QCheckBox::toggled, further, &QWidget::setEnabled);
    }
    connect(this, &QDialog::accepted, this, [this] { emit chosen(this->options()); });
}

ShareOptions PackDialog::options() const
{
    const auto of = [](const QCheckBox& box) { return box.isChecked() ? Toggle::On : Toggle::Off; };
    return {deidentify_->isChecked() ? Toggle::Off : Toggle::On, of(*shiftedDates_), of(*maskText_),
            pseudonym_->text()};
}

DeidentifyDialog::DeidentifyDialog(QWidget* parent)
    : QDialog(parent),
      inputs_(new QListWidget),
      remove_(new QPushButton(tr("Remove"))),
      shiftedDates_(new QCheckBox(tr("Shift dates instead of removing them"))),
      maskText_(new QCheckBox(tr("Mask burned-in text"))),
      pseudonym_(new QLineEdit),
      output_(new QLineEdit),
      accept_(new QPushButton(tr("Write")))
{
    setObjectName(QStringLiteral("deidentifyDialog"));
    setWindowTitle(tr("De-identify files"));
    setAttribute(Qt::WA_DeleteOnClose);
    setMinimumWidth(600);
    auto* hint = roleLabel("hint", tr("DICOM images and objects and PNG, JPEG and TIFF files are copied without names, "
                                      "IDs, dates, private elements and free text; UIDs are replaced. Other files are "
                                      "skipped and listed. Review every image before sharing."));
    hint->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(22, 20, 22, 16);
    layout->setSpacing(12);
    layout->addWidget(hint);
    layout->addWidget(makeInputs());
    layout->addWidget(makeOptions());
    layout->addLayout(dialogButtons(*this, tr("Cancel"), *accept_));
    connect(this, &QDialog::accepted, this, [this] { emit chosen(options()); });
    showState();
}

QWidget* DeidentifyDialog::makeInputs()
{
    inputs_->setAccessibleName(tr("Files and folders"));
    inputs_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    inputs_->setFixedHeight(inputListHeight);
    inputs_->setTextElideMode(Qt::ElideMiddle);
    inputs_->setProperty("role", "well");
    auto* files = new QPushButton(tr("Add files…"));
    auto* folder = new QPushButton(tr("Add folder…"));
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {files, folder, remove_}) {
        button->setAutoDefault(false);
        buttons->addWidget(button);
    }
    buttons->addStretch(1);
    connect(files, &QPushButton::clicked, this, &DeidentifyDialog::addFilesRequested);
    connect(folder, &QPushButton::clicked, this, &DeidentifyDialog::addFolderRequested);
    connect(remove_, &QPushButton::clicked, this, &DeidentifyDialog::removeSelected);
    connect(inputs_, &QListWidget::itemSelectionChanged, this, &DeidentifyDialog::showState);
    auto* part = new QWidget;
    auto* layout = new QVBoxLayout(part);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(roleLabel("label", tr("Files and folders")));
    layout->addWidget(inputs_);
    layout->addLayout(buttons);
    return part;
}

QWidget* DeidentifyDialog::makeOptions()
{
    maskText_->setChecked(true);
    pseudonym_->setPlaceholderText(tr("automatic"));
    output_->setPlaceholderText(tr("a new or empty folder"));
    output_->setAccessibleName(tr("Output folder"));
    auto* choose = new QPushButton(tr("Choose…"));
    choose->setAutoDefault(false);
    auto* outputRow = new QHBoxLayout;
    outputRow->addWidget(output_, 1);
    outputRow->addWidget(choose);
    auto* part = new QWidget;
    auto* form = new QFormLayout(part);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(shiftedDates_);
    form->addRow(maskText_);
    form->addRow(tr("Pseudonym"), pseudonym_);
    form->addRow(tr("Write to"), outputRow);
    connect(choose, &QPushButton::clicked, this, &DeidentifyDialog::outputFolderRequested);
    connect(output_, &QLineEdit::textChanged, this, &DeidentifyDialog::showState);
    return part;
}

void DeidentifyDialog::addPaths(const QStringList& paths)
{
    for (const QString& path : paths) {
        if (inputs_->findItems(path, Qt::MatchExactly).isEmpty()) {
            inputs_->addItem(path);
            inputs_->item(inputs_->count() - 1)->setToolTip(path);
        }
    }
    showState();
}

void DeidentifyDialog::setOutputFolder(const QString& folder)
{
    output_->setText(folder);
}

void DeidentifyDialog::removeSelected()
{
    qDeleteAll(inputs_->selectedItems());
    showState();
}

void DeidentifyDialog::showState()
{
    remove_->setEnabled(!inputs_->selectedItems().isEmpty());
    accept_->setEnabled(inputs_->count() > 0 && !output_->text().trimmed().isEmpty());
}

DeidentifyOptions DeidentifyDialog::options() const
{
    const auto of = [](const QCheckBox& box) { return box.isChecked() ? Toggle::On : Toggle::Off; };
    QStringList paths;
    for (int i = 0; i < inputs_->count(); ++i) {
        paths << inputs_->item(i)->text();
    }
    return {paths, output_->text().trimmed(), {Toggle::Off, of(*shiftedDates_), of(*maskText_), pseudonym_->text()}};
}

}   // namespace angiopose::ui

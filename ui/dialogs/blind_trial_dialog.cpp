#include "ui/dialogs/blind_trial_dialog.h"

#include "ui/controls/number_field.h"
#include "ui/controls/section.h"

#include <QFileDialog>
#include <QFormLayout>
#include <QPushButton>

namespace angiopose::ui {
namespace {

constexpr int blindTrialDialogWidth = 560;

NumberField* numberField(const QString& name, const NumberFormat& format, double value)
{
    auto* field = new NumberField(format);
    field->setAccessibleName(name);
    field->showValue(value);
    return field;
}

}   // namespace

BlindTrialDialog::BlindTrialDialog(const BlindTrialSetup& suggested, QWidget* parent)
    : QDialog(parent),
      observer_(new QLineEdit(suggested.observer)),
      seed_(numberField(tr("Seed"), {0.0, 1e9, 0, {}, 1.0}, static_cast<double>(suggested.seed))),
      rangeMm_(numberField(tr("Max. initial shift"), {0.0, 200.0, 1, tr("mm"), 1.0}, suggested.rangeMm)),
      rangeDeg_(numberField(tr("Max. initial rotation"), {0.0, 90.0, 1, tr("°"), 1.0}, suggested.rangeDeg)),
      log_(new QLineEdit(suggested.logPath)),
      start_(new QPushButton(tr("Start trial")))
{
    setObjectName(QStringLiteral("blindTrialDialog"));
    setWindowTitle(tr("Blind observer trial"));
    setAttribute(Qt::WA_DeleteOnClose);
    setMinimumWidth(blindTrialDialogWidth);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(22, 20, 22, 16);
    layout->setSpacing(14);
    layout->addWidget(makeIntroduction());
    layout->addLayout(makeForm());
    layout->addLayout(makeButtons());

    connect(observer_, &QLineEdit::textChanged, this, &BlindTrialDialog::updateButton);
    connect(log_, &QLineEdit::textChanged, this, &BlindTrialDialog::updateButton);
    connect(start_, &QPushButton::clicked, this, [this] {
        const BlindTrialSetup entered = setup();
        accept();
        emit startRequested(entered);
    });
    updateButton();
}

QWidget* BlindTrialDialog::makeIntroduction()
{
    auto* words = roleLabel(
        "body",
        tr("The vessels start in a random pose near the current one. Until you choose “Done”, all numbers, residual "
           "colors and earlier poses are hidden. The time and the final pose are logged; the case is not changed."));
    words->setWordWrap(true);
    return words;
}

QFormLayout* BlindTrialDialog::makeForm()
{
    observer_->setAccessibleName(tr("Observer"));
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(14);
    form->setVerticalSpacing(10);
    form->addRow(roleLabel("label", tr("Observer")), observer_);
    form->addRow(roleLabel("label", tr("Max. initial shift")), rangeMm_);
    form->addRow(roleLabel("label", tr("Max. initial rotation")), rangeDeg_);
    form->addRow(roleLabel("label", tr("Seed")), seed_);
    form->addRow(roleLabel("label", tr("Log")), makeLogRow());
    return form;
}

QHBoxLayout* BlindTrialDialog::makeLogRow()
{
    log_->setAccessibleName(tr("Log"));
    auto* choose = new QPushButton(tr("Choose…"));
    choose->setAutoDefault(false);
    connect(choose, &QPushButton::clicked, this, &BlindTrialDialog::chooseLog);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(log_, 1);
    row->addWidget(choose);
    return row;
}

QHBoxLayout* BlindTrialDialog::makeButtons()
{
    auto* cancel = new QPushButton(tr("Cancel"));
    cancel->setAutoDefault(false);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    start_->setProperty("role", "primary");
    start_->setDefault(true);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(cancel);
    buttons->addWidget(start_);
    return buttons;
}

BlindTrialSetup BlindTrialDialog::setup() const
{
    return {observer_->text().trimmed(), static_cast<std::uint64_t>(seed_->value().value_or(1.0)),
            rangeMm_->value().value_or(0.0), rangeDeg_->value().value_or(0.0), log_->text().trimmed()};
}

void BlindTrialDialog::chooseLog()
{
    auto* dialog = new QFileDialog(this, tr("Trial log"), log_->text(), tr("Tables (*.csv)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setOption(QFileDialog::DontConfirmOverwrite);   // new trials are appended to an existing file
    dialog->setDefaultSuffix(QStringLiteral("csv"));
    connect(dialog, &QFileDialog::fileSelected, log_, &QLineEdit::setText);
    dialog->open();
}

void BlindTrialDialog::updateButton()
{
    const bool isComplete = !observer_->text().trimmed().isEmpty() && !log_->text().trimmed().isEmpty();
    start_->setEnabled(isComplete);
    start_->setToolTip(isComplete ? QString() : tr("Enter the observer and choose a log file."));
}

}   // namespace angiopose::ui

#include "ui/panels/registration_panel.h"

#include "ui/actions/key_hint.h"
#include "ui/help/help_page.h"
#include "ui/panels/option_form.h"
#include "ui/words/core_texts.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>

namespace ui {
namespace {

QString fromView(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

}   // namespace

RegistrationPanel::RegistrationPanel(QWidget* parent)
    : Section(tr("Registration"), Folding::Fixed, parent),
      method_(new QComboBox),
      summary_(roleLabel("hint")),
      form_(new OptionForm),
      optionSection_(new Section(tr("Method and options"), Folding::Foldable)),
      register_(new QPushButton),
      stop_(new QPushButton(tr("Stop"))),
      lockNote_(roleLabel("hint"))
{
    register_->setProperty("role", "primary");
    register_->setAccessibleName(tr("Register"));
    stop_->setToolTip(tr("Ends the run and keeps the best pose so far."));
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(register_, 5);
    buttons->addWidget(stop_, 2);

    method_->setAccessibleName(tr("Method"));
    for (const core::MethodInfo& info : core::methodInfos()) {
        method_->addItem(fromView(info.label), QByteArray(info.id.data(), static_cast<qsizetype>(info.id.size())));
        method_->setItemData(method_->count() - 1, coreText(info.summary), Qt::ToolTipRole);
    }
    summary_->setWordWrap(true);
    optionSection_->contentLayout()->addLayout(methodRow());
    optionSection_->contentLayout()->addWidget(summary_);
    optionSection_->contentLayout()->addWidget(form_);
    optionSection_->layout()->setContentsMargins(0, 2, 0, 0);
    optionSection_->setFolded(true);

    lockNote_->setWordWrap(true);
    contentLayout()->addLayout(buttons);
    contentLayout()->addWidget(lockNote_);
    contentLayout()->addWidget(optionSection_);

    connect(register_, &QPushButton::clicked, this, &RegistrationPanel::registerRequested);
    connect(stop_, &QPushButton::clicked, this, &RegistrationPanel::stopRequested);
    connect(method_, &QComboBox::activated, this, &RegistrationPanel::chooseMethod);
    connect(form_, &OptionForm::edited, this, &RegistrationPanel::optionsEdited);
    showOptions(options_);
    updateButtons();
}

/// The choice, and a button that tells about what is chosen.
QHBoxLayout* RegistrationPanel::methodRow()
{
    auto* about = new QToolButton;
    about->setText(QStringLiteral("?"));
    about->setAccessibleName(tr("About this method"));
    about->setToolTip(tr("What this method minimises, when it fails, and its source."));
    connect(about, &QToolButton::clicked, this, [this] {
        auto* help = new HelpPage(QStringLiteral("methods/") + method_->currentData().toString(),
                                  tr("About this method"), window());
        help->open();
    });
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    row->addWidget(method_, 1);
    row->addWidget(about);
    return row;
}

void RegistrationPanel::showOptions(const core::RegistrationOptions& options)
{
    options_ = options;
    const int index = method_->findData(QByteArray::fromStdString(options.method));
    method_->setCurrentIndex(index);
    summary_->setText(index >= 0 ? method_->itemData(index, Qt::ToolTipRole).toString() : QString());
    form_->showOptions(options);
    showLocks(static_cast<int>(std::ranges::count(options.locks, true)));
    showAuxiliary(auxiliaryCount_);
}

void RegistrationPanel::showAuxiliary(int branchCount)
{
    auxiliaryCount_ = branchCount;
    const QString branches = branchCount == 1 ? tr("aux: 1 branch") : tr("aux: %1 branches").arg(branchCount);
    const QString auxiliary = branchCount == 0 ? tr("aux: nodes") : branches;
    setHint(tr("%1 · %2").arg(method_->currentText(), auxiliary));
}

void RegistrationPanel::showLocks(int count)
{
    lockNote_->setVisible(count > 0);
    lockNote_->setText(count == 1 ? tr("Register keeps the locked degree of freedom.")
                                  : tr("Register keeps the %1 locked degrees of freedom.").arg(count));
}

void RegistrationPanel::showReady(const QString& whyNot)
{
    whyNot_ = whyNot;
    updateButtons();
}

void RegistrationPanel::setRunning(bool running)
{
    running_ = running;
    updateButtons();
}

void RegistrationPanel::chooseMethod(int index)
{
    options_.method = method_->itemData(index).toByteArray().toStdString();
    showOptions(options_);
    emit optionsEdited(options_, tr("method"));
}

void RegistrationPanel::updateButtons()
{
    register_->setEnabled(!running_ && whyNot_.isEmpty());
    register_->setToolTip(whyNot_.isEmpty() ? tipWithKey(tr("Finds the pose that lays the vessels onto the angiogram."),
                                                         Command::Register)
                                            : whyNot_);
    register_->setText(running_ ? tr("Registering …") : withKey(tr("Register"), Command::Register));
    stop_->setEnabled(running_);
    method_->setEnabled(!running_);
    form_->setEnabled(!running_);
}

}   // namespace ui

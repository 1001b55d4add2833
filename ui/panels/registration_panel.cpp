#include "ui/panels/registration_panel.h"

#include "core/registration/methods/method_info.h"
#include "ui/actions/key_hint.h"
#include "ui/help/help_page.h"
#include "ui/panels/option_form.h"
#include "ui/words/retranslation.h"
#include "ui/words/terms.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>

namespace angiopose::ui {
namespace {

QString textFrom(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

}   // namespace

RegistrationPanel::RegistrationPanel(QWidget* parent)
    : Section(
          "registration", [] { return tr("Registration"); }, Folding::Fixed, parent),
      method_(new QComboBox),
      summary_(roleLabel("hint")),
      form_(new OptionForm),
      optionSection_(new Section(
          "registration/options", [] { return tr("Method and options"); }, Folding::Foldable)),
      register_(new QPushButton),
      stop_(withText(new QPushButton, [] { return tr("Stop"); })),
      lockNote_(roleLabel("hint")),
      allViews_(new QCheckBox)
{
    register_->setProperty("role", "primary");
    withAccessibleName(register_, [] { return tr("Register"); });
    withToolTip(stop_, [] { return tr("Stops the registration and keeps the best pose so far."); });
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(register_, 5);
    buttons->addWidget(stop_, 2);

    withAccessibleName(method_, [] { return tr("Method"); });
    for (const core::MethodInfo& info : core::methodInfos()) {
        method_->addItem(textFrom(info.label), QByteArray(info.id.data(), static_cast<qsizetype>(info.id.size())));
    }
    summary_->setWordWrap(true);
    optionSection_->contentLayout()->addLayout(methodRow());
    optionSection_->contentLayout()->addWidget(summary_);
    optionSection_->contentLayout()->addWidget(form_);
    optionSection_->layout()->setContentsMargins(0, 2, 0, 0);
    optionSection_->setFolded(true);

    lockNote_->setWordWrap(true);
    contentLayout()->addLayout(buttons);
    allViews_->setChecked(true);
    withToolTip(allViews_, [] {
        return tr(
            "Uses one pose for all views. Moving the vessels manually moves them in every view. Registration fits all "
            "views jointly with the method AngioPose: the depth in one view is then determined by the in-plane "
            "translation in another. If off, only the displayed view is used.");
    });
    contentLayout()->addWidget(allViews_);
    contentLayout()->addWidget(lockNote_);
    contentLayout()->addWidget(optionSection_);

    connect(register_, &QPushButton::clicked, this, &RegistrationPanel::registerRequested);
    connect(stop_, &QPushButton::clicked, this, &RegistrationPanel::stopRequested);
    connect(allViews_, &QCheckBox::toggled, this, &RegistrationPanel::allViewsToggled);
    connect(method_, &QComboBox::activated, this, &RegistrationPanel::chooseMethod);
    connect(form_, &OptionForm::edited, this, &RegistrationPanel::optionsEdited);
    showViewCount(1);
    keepTranslated(this, [this] { updateTexts(); });
}

/// Updates the text that depends on the language and on the current state.
void RegistrationPanel::updateTexts()
{
    int index = 0;
    for (const core::MethodInfo& info : core::methodInfos()) {
        method_->setItemData(index++, termText(info.summary), Qt::ToolTipRole);
    }
    showOptions(options_);
    showViewCount(viewCount_);
    updateButtons();
}

/// Creates the method selector and a button that explains the selected method.
QHBoxLayout* RegistrationPanel::methodRow()
{
    auto* about = new QToolButton;
    about->setText(QStringLiteral("?"));
    withAccessibleName(about, [] { return tr("About this method"); });
    withToolTip(about, [] {
        return tr("Explains which cost this method minimizes, when the method fails, and where it was published.");
    });
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
    if (branchCount == 0) {
        setHint(method_->currentText());
        return;
    }
    const QString branches = branchCount == 1 ? tr("1 auxiliary branch") : tr("%1 auxiliary branches").arg(branchCount);
    setHint(tr("%1 · %2").arg(method_->currentText(), branches));
}

void RegistrationPanel::showLocks(int count)
{
    lockNote_->setVisible(count > 0);
    lockNote_->setText(count == 1 ? tr("Registration keeps the locked degree of freedom fixed.")
                                  : tr("Registration keeps the %1 locked degrees of freedom fixed.").arg(count));
}

void RegistrationPanel::showViewCount(int count)
{
    viewCount_ = count;
    allViews_->setVisible(count > 1);
    allViews_->setText(tr("Register all %1 views jointly").arg(count));
}

void RegistrationPanel::showBlockingReason(const QString& whyNot)
{
    blockingReason_ = whyNot;
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
    emit optionsEdited(options_, [] { return tr("method"); });
}

void RegistrationPanel::updateButtons()
{
    register_->setEnabled(!running_ && blockingReason_.isEmpty());
    register_->setToolTip(
        blockingReason_.isEmpty()
            ? tooltipWithShortcut(tr("Finds the pose that aligns the vessels with the angiogram."), Command::Register)
            : blockingReason_);
    register_->setText(running_ ? tr("Registering…") : withShortcut(tr("Register"), Command::Register));
    stop_->setEnabled(running_);
    method_->setEnabled(!running_);
    form_->setEnabled(!running_);
    allViews_->setEnabled(!running_);
}

}   // namespace angiopose::ui

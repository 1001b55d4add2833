#include "ui/dialogs/report_dialog.h"

#include "ui/controls/section.h"
#include "ui/dialogs/dialog_buttons.h"

#include <QCheckBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace angiopose::ui {

ReportDialog::ReportDialog(const ReportOptions& options, QWidget* parent)
    : QDialog(parent),
      template_(new ElidedLabel("body")),
      builtIn_(new QPushButton(tr("Use built-in"))),
      identity_(new QCheckBox(tr("Patient identity in the report")))
{
    setObjectName(QStringLiteral("reportDialog"));
    setWindowTitle(tr("Export report"));
    setAttribute(Qt::WA_DeleteOnClose);
    setMinimumWidth(460);
    template_->setObjectName(QStringLiteral("reportTemplate"));
    identity_->setChecked(options.identity == Toggle::On);
    auto* passedOn = roleLabel("hint", tr("Leave this off if the report will be shared: it is then anonymous."));
    passedOn->setWordWrap(true);
    auto* about = roleLabel("hint", tr("Templates are HTML pages with your letterhead and logo. Save a copy of the "
                                       "built-in template and edit the copy; it contains instructions."));
    about->setWordWrap(true);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(14);
    form->setVerticalSpacing(10);
    form->addRow(roleLabel("label", tr("Template")), template_);
    form->addRow(QString(), makeTemplateButtons());
    form->addRow(QString(), about);
    form->addRow(roleLabel("label", tr("Patient")), identity_);
    form->addRow(QString(), passedOn);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(22, 20, 22, 16);
    layout->setSpacing(14);
    layout->addLayout(form);
    layout->addLayout(dialogButtons(*this, tr("Cancel"), *new QPushButton(tr("Export…"))));
    connect(builtIn_, &QPushButton::clicked, this, [this] { showTemplate({}); });
    connect(this, &QDialog::accepted, this, [this] { emit chosen(this->options()); });
    showTemplate(options.templatePath);
}

QHBoxLayout* ReportDialog::makeTemplateButtons()
{
    auto* choose = new QPushButton(tr("Choose…"));
    auto* copy = new QPushButton(tr("Save a copy…"));
    copy->setToolTip(tr("Saves the built-in template for editing"));
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    for (QPushButton* button : {choose, builtIn_, copy}) {
        button->setAutoDefault(false);
        buttons->addWidget(button);
    }
    connect(choose, &QPushButton::clicked, this, &ReportDialog::templateRequested);
    connect(copy, &QPushButton::clicked, this, &ReportDialog::templateCopyRequested);
    return buttons;
}

void ReportDialog::showTemplate(const QString& path)
{
    templatePath_ = path;
    template_->showText(path.isEmpty() ? tr("built-in") : QFileInfo(path).fileName());
    builtIn_->setEnabled(!path.isEmpty());
}

ReportOptions ReportDialog::options() const
{
    return {identity_->isChecked() ? Toggle::On : Toggle::Off, templatePath_};
}

}   // namespace angiopose::ui

#include "ui/dialogs/prune_dialog.h"

#include "ui/controls/number_field.h"
#include "ui/controls/section.h"
#include "ui/words/number.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>

namespace angiopose::ui {
namespace {

/// Returns the number in the field, or `before` if the text is not a valid number.
double numberIn(const QLineEdit& field, double before)
{
    const auto typed = numberFrom(field.text());
    return typed && *typed >= 0.0 ? *typed : before;
}

}   // namespace

PruneDialog::PruneDialog(std::function<int(const PruneLimits&)> countPruned, QWidget* parent)
    : QDialog(parent),
      countPruned_(std::move(countPruned)),
      length_(new NumberField({0.0, 1000.0, 1, tr("mm"), 1.0})),
      radius_(new NumberField({0.0, 1000.0, 2, tr("mm"), 0.1})),
      count_(roleLabel("body")),
      prune_(new QPushButton(tr("Prune")))
{
    setObjectName(QStringLiteral("pruneDialog"));
    setWindowTitle(tr("Prune"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(22, 20, 22, 16);
    layout->setSpacing(12);
    layout->addWidget(roleLabel("heading", tr("Remove terminal branches that are")));
    length_->setAccessibleName(tr("shorter than"));
    radius_->setAccessibleName(tr("thinner than (mean radius)"));
    auto* form = new QFormLayout;
    form->addRow(tr("shorter than"), length_);
    form->addRow(tr("thinner than (mean radius)"), radius_);
    layout->addLayout(form);
    count_->setMinimumWidth(320);
    layout->addWidget(count_);
    auto* buttons = new QHBoxLayout;
    auto* cancel = new QPushButton(tr("Cancel"));
    prune_->setProperty("role", "primary");
    prune_->setDefault(true);
    buttons->addStretch(1);
    buttons->addWidget(cancel);
    buttons->addWidget(prune_);
    layout->addLayout(buttons);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(prune_, &QPushButton::clicked, this, [this] {
        emit pruneRequested(limits_);
        accept();
    });
    for (NumberField* field : {length_, radius_}) {   // updates the count while typing
        connect(field, &QLineEdit::textChanged, this, &PruneDialog::showCount);
    }
    const PruneLimits start;
    length_->showValue(start.minLengthMm);
    radius_->showValue(start.minRadiusMm);
    showCount();
}

void PruneDialog::showCount()
{
    limits_.minLengthMm = numberIn(*length_, limits_.minLengthMm);
    limits_.minRadiusMm = numberIn(*radius_, limits_.minRadiusMm);
    const int count = countPruned_(limits_);
    count_->setText(count < 0    ? tr("No branch would remain. Lower the limits.")
                    : count == 0 ? tr("Nothing to remove.")
                    : count == 1 ? tr("1 branch will be removed.")
                                 : tr("%1 branches will be removed.").arg(count));
    prune_->setEnabled(count > 0);
}

}   // namespace angiopose::ui

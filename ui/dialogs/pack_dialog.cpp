#include "ui/dialogs/pack_dialog.h"

#include "ui/controls/section.h"
#include "ui/dialogs/dialog_buttons.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace angiopose::ui {

PackDialog::PackDialog(QWidget* parent)
    : QDialog(parent),
      nameless_(new QCheckBox(tr("Without identity"))),
      shiftedDates_(new QCheckBox(tr("Dates shifted instead of removed"))),
      blackedOut_(new QCheckBox(tr("Black out letters in the pictures"))),
      pseudonym_(new QLineEdit)
{
    setObjectName(QStringLiteral("packDialog"));
    setWindowTitle(tr("Pack case for others"));
    setAttribute(Qt::WA_DeleteOnClose);
    setMinimumWidth(460);
    nameless_->setChecked(true);
    blackedOut_->setChecked(true);
    pseudonym_->setPlaceholderText(tr("made up"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(22, 20, 22, 16);
    layout->setSpacing(10);
    for (QCheckBox* box : {nameless_, shiftedDates_, blackedOut_}) {
        layout->addWidget(box);
    }
    auto* form = new QFormLayout;
    form->addRow(tr("Name instead"), pseudonym_);
    layout->addLayout(form);
    auto* hint =
        roleLabel("hint", tr("One archive with the case, its inputs and its results. Without identity: no names, "
                             "IDs, dates, private elements and notes; UIDs are replaced. Names of branches stay. "
                             "Look at every picture before you hand it on."));
    hint->setWordWrap(true);
    layout->addWidget(hint);
    auto* pack = new QPushButton(tr("Pack …"));
    layout->addLayout(dialogButtons(*this, tr("Cancel"), *pack));
    for (QWidget* further : std::initializer_list<QWidget*>{shiftedDates_, blackedOut_, pseudonym_}) {
        connect(nameless_, &QCheckBox::toggled, further, &QWidget::setEnabled);
    }
    connect(this, &QDialog::accepted, this, [this] { emit chosen(this->choice()); });
}

PackChoice PackDialog::choice() const
{
    const auto of = [](const QCheckBox& box) { return box.isChecked() ? Choice::On : Choice::Off; };
    return {nameless_->isChecked() ? Choice::Off : Choice::On, of(*shiftedDates_), of(*blackedOut_),
            pseudonym_->text()};
}

}   // namespace angiopose::ui

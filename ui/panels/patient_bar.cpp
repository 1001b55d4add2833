#include "ui/panels/patient_bar.h"

#include "ui/controls/section.h"
#include "ui/words/retranslation.h"

#include <QHBoxLayout>

namespace angiopose::ui {

PatientBar::PatientBar(QWidget* parent)
    : QWidget(parent), warning_(roleLabel("attention")), name_(roleLabel("title")), details_(new ElidedLabel("label"))
{
    setProperty("role", "stepBar");
    setAttribute(Qt::WA_StyledBackground);
    withAccessibleName(this, [] { return tr("Patient"); });
    warning_->setObjectName(QStringLiteral("patientDoubt"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(14, 2, 14, 4);
    layout->setSpacing(12);
    layout->addWidget(warning_);
    layout->addWidget(name_);
    layout->addWidget(details_, 1);
    setMinimumWidth(1);
    hide();
}

void PatientBar::showPatient(const PatientText& line)
{
    warning_->setText(line.warning);
    warning_->setVisible(!line.warning.isEmpty());
    name_->setText(line.name);
    name_->setVisible(!line.name.isEmpty());
    details_->showText(line.details);
    setVisible(!(line.warning.isEmpty() && line.name.isEmpty() && line.details.isEmpty()));
}

}   // namespace angiopose::ui

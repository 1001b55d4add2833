#include "app/showing/patient_controller.h"

#include "app/words/patient_words.h"
#include "core/case/case_patients.h"
#include "ui/words/retranslation.h"

#include <QCoreApplication>

namespace angiopose::app {
namespace {

struct PatientWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::PatientController)
};

auto lineOf(const core::Case& session, bool isHidden)
{
    const std::vector<core::CasePatient> patients = core::patientsOf(session);
    ui::PatientText line;
    if (patients.size() > 1) {
        line.warning = PatientWords::tr("The inputs belong to different patients");
    } else if (!core::findMismatch(session).empty()) {
        line.warning = PatientWords::tr("The inputs do not match");
    }
    if (patients.empty()) {
        return line;
    }
    if (isHidden) {
        line.details = PatientWords::tr("Identity hidden (Shift+P shows it)");
    } else if (patients.size() == 1) {
        line.name = readableName(patients.front().identity.patientName);
        const QString details = patientDetails(patients.front());
        const QString inputs = patientInputs(patients.front(), session.views.size());
        line.details =
            details.isEmpty() ? QStringLiteral("(%1)").arg(inputs) : QStringLiteral("%1 (%2)").arg(details, inputs);
    } else {
        line.details = patientLines(session).join(QStringLiteral("   "));
    }
    return line;
}

}   // namespace

PatientController::PatientController(const CaseDocument& document, ui::PatientBar& bar, const QAction& hideIdentity,
                                     QObject* parent)
    : QObject(parent), document_(document), bar_(bar), hideIdentity_(hideIdentity)
{
    connect(&document_, &CaseDocument::changed, this, &PatientController::show);
    connect(&hideIdentity_, &QAction::toggled, this, &PatientController::show);
    ui::keepTranslated(this, [this] { show(); });
}

void PatientController::show()
{
    bar_.showPatient(lineOf(document_.current(), hideIdentity_.isChecked()));
}

}   // namespace angiopose::app

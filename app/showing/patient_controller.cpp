#include "app/showing/patient_controller.h"

#include "core/case/case_patients.h"
#include "ui/words/spoken.h"

#include <QCoreApplication>

namespace angiopose::app {
namespace {

/// The words of this file.
struct PatientWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::PatientController)
};

QString readableName(const std::string& name)
{
    return QString::fromStdString(name).replace(u'^', u' ').simplified();
}

/// "scan, view 1, view 2"; of a case with one view "scan, angiogram"
QString inputsOf(const core::CasePatient& patient, std::size_t viewCount)
{
    QStringList inputs;
    if (patient.isOfScan) {
        inputs << PatientWords::tr("scan");
    }
    for (const std::size_t place : patient.views) {
        inputs << (viewCount > 1 ? PatientWords::tr("view %1").arg(place + 1) : PatientWords::tr("angiogram"));
    }
    return inputs.join(QStringLiteral(", "));
}

QString detailsOf(const core::CasePatient& patient)
{
    const core::StudyIdentity& identity = patient.identity;
    QStringList parts;
    if (!identity.patientId.empty()) {
        parts << PatientWords::tr("ID %1").arg(QString::fromStdString(identity.patientId));
    }
    if (!identity.birthDate.empty()) {
        parts << PatientWords::tr("born %1").arg(QString::fromStdString(identity.birthDate));
    }
    if (!identity.sex.empty()) {
        parts << QString::fromStdString(identity.sex);
    }
    return parts.join(QStringLiteral(" · "));
}

/// "Doe Jane · ID 0815 · born 1950-01-02 · F (scan)"
QString oneOfSeveral(const core::CasePatient& patient, std::size_t viewCount)
{
    QStringList parts{readableName(patient.identity.patientName), detailsOf(patient)};
    parts.removeAll(QString());
    return QStringLiteral("%1 (%2)").arg(parts.join(QStringLiteral(" · ")), inputsOf(patient, viewCount));
}

auto lineOf(const core::Case& theCase, bool isHidden)
{
    const std::vector<core::CasePatient> patients = core::patientsOf(theCase);
    ui::PatientLine line;
    if (patients.size() > 1) {
        line.doubt = PatientWords::tr("Not the same patient in all inputs");
    } else if (!core::findMismatch(theCase).empty()) {
        line.doubt = PatientWords::tr("The inputs do not belong together");
    }
    if (patients.empty()) {
        return line;
    }
    if (isHidden) {
        line.details = PatientWords::tr("Identity hidden (Shift+P shows it)");
    } else if (patients.size() == 1) {
        line.name = readableName(patients.front().identity.patientName);
        const QString details = detailsOf(patients.front());
        const QString inputs = inputsOf(patients.front(), theCase.views.size());
        line.details =
            details.isEmpty() ? QStringLiteral("(%1)").arg(inputs) : QStringLiteral("%1 (%2)").arg(details, inputs);
    } else {
        QStringList all;
        for (const core::CasePatient& patient : patients) {
            all << oneOfSeveral(patient, theCase.views.size());
        }
        line.details = all.join(QStringLiteral("   "));
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
    ui::speak(this, [this] { show(); });
}

void PatientController::show()
{
    bar_.showPatient(lineOf(document_.current(), hideIdentity_.isChecked()));
}

}   // namespace angiopose::app

#include "app/words/patient_words.h"

#include <QCoreApplication>

namespace angiopose::app {
namespace {

struct PatientLineWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::PatientController)
};

}   // namespace

QString readableName(const std::string& name)
{
    return QString::fromStdString(name).replace(u'^', u' ').simplified();
}

QString patientInputs(const core::CasePatient& patient, std::size_t viewCount)
{
    QStringList inputs;
    if (patient.isScanPatient) {
        inputs << PatientLineWords::tr("scan");
    }
    for (const std::size_t place : patient.views) {
        inputs << (viewCount > 1 ? PatientLineWords::tr("view %1").arg(place + 1) : PatientLineWords::tr("angiogram"));
    }
    return inputs.join(QStringLiteral(", "));
}

QString patientDetails(const core::CasePatient& patient)
{
    const core::StudyIdentity& identity = patient.identity;
    QStringList parts;
    if (!identity.patientId.empty()) {
        parts << PatientLineWords::tr("ID %1").arg(QString::fromStdString(identity.patientId));
    }
    if (!identity.birthDate.empty()) {
        parts << PatientLineWords::tr("born %1").arg(QString::fromStdString(identity.birthDate));
    }
    if (!identity.sex.empty()) {
        parts << QString::fromStdString(identity.sex);
    }
    return parts.join(QStringLiteral(" · "));
}

QStringList patientLines(const core::Case& session)
{
    QStringList lines;
    for (const core::CasePatient& patient : core::patientsOf(session)) {
        QStringList parts{readableName(patient.identity.patientName), patientDetails(patient)};
        parts.removeAll(QString());
        lines << QStringLiteral("%1 (%2)").arg(parts.join(QStringLiteral(" · ")),
                                               patientInputs(patient, session.views.size()));
    }
    return lines;
}

}   // namespace angiopose::app

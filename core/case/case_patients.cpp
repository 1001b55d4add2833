#include "core/case/case_patients.h"

#include "core/imaging/patient_match.h"

#include <algorithm>

namespace angiopose::core {
namespace {

bool identifiesPatient(const StudyIdentity& identity)
{
    return !identity.patientName.empty() || !identity.patientId.empty() || !identity.birthDate.empty();
}

/// Fills the empty fields of `identity` from `other`.
void fillEmptyFields(StudyIdentity& identity, const StudyIdentity& other)
{
    for (const auto part :
         {&StudyIdentity::patientName, &StudyIdentity::patientId, &StudyIdentity::birthDate, &StudyIdentity::sex}) {
        if ((identity.*part).empty()) {
            identity.*part = other.*part;
        }
    }
}

CasePatient& patientOf(std::vector<CasePatient>& patients, const StudyIdentity& identity)
{
    const auto known = std::ranges::find_if(
        patients, [&identity](const CasePatient& patient) { return !findPatientMismatch(patient.identity, identity); });
    if (known == patients.end()) {
        return patients.emplace_back(CasePatient{identity, false, {}});
    }
    fillEmptyFields(known->identity, identity);
    return *known;
}

}   // namespace

Messages findMismatch(const Case& session)
{
    Messages found;
    const auto compare = [&found](const StudyIdentity& one, const StudyIdentity& other, ComparedImages compared) {
        for (const Message& mismatch : findMismatch(one, other, compared)) {
            if (std::ranges::find(found, mismatch) == found.end()) {
                found.push_back(mismatch);
            }
        }
    };
    for (std::size_t k = 0; k < session.views.size(); ++k) {
        const auto& run = session.views[k].angiogram;
        if (!run) {
            continue;
        }
        compare(session.vessels.scanIdentity, run->identity, ComparedImages::ScanAndRun);
        for (std::size_t before = 0; before < k; ++before) {
            if (const auto& other = session.views[before].angiogram) {
                compare(other->identity, run->identity, ComparedImages::TwoRuns);
            }
        }
    }
    return found;
}

std::vector<CasePatient> patientsOf(const Case& session)
{
    std::vector<CasePatient> patients;
    if (identifiesPatient(session.vessels.scanIdentity)) {
        patientOf(patients, session.vessels.scanIdentity).isScanPatient = true;
    }
    for (std::size_t viewIndex = 0; viewIndex < session.views.size(); ++viewIndex) {
        const auto& run = session.views[viewIndex].angiogram;
        if (run && identifiesPatient(run->identity)) {
            patientOf(patients, run->identity).views.push_back(viewIndex);
        }
    }
    return patients;
}

}   // namespace angiopose::core

#pragma once

#include "core/case/case_patients.h"

#include <QString>
#include <QStringList>

namespace angiopose::app {

QString readableName(const std::string& name);   ///< formats a DICOM name such as "Doe^Jane" for display

/// Lists the inputs that belong to a patient, e.g. "scan, view 1, view 2"; for a case with one view, "scan, angiogram".
QString patientInputs(const core::CasePatient& patient, std::size_t viewCount);

/// Formats the patient details, e.g. "ID 0815 · born 1950-01-02 · F".
QString patientDetails(const core::CasePatient& patient);

/// Returns one line per patient, e.g. "Doe Jane · ID 0815 · born 1950-01-02 · F (scan)".
QStringList patientLines(const core::Case& session);

}   // namespace angiopose::app

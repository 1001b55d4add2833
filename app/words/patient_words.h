#pragma once

#include "core/case/case_patients.h"

#include <QString>
#include <QStringList>

namespace angiopose::app {

QString readableName(const std::string& name);   ///< from a DICOM name such as "Doe^Jane"

/// "scan, view 1, view 2"; for a case with one view "scan, angiogram"
QString inputsOf(const core::CasePatient& patient, std::size_t viewCount);

/// "ID 0815 · born 1950-01-02 · F"
QString detailsOf(const core::CasePatient& patient);

/// One line per patient: "Doe Jane · ID 0815 · born 1950-01-02 · F (scan)".
QStringList patientLines(const core::Case& session);

}   // namespace angiopose::app

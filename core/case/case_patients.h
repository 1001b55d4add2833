#pragma once

#include "core/case/case.h"
#include "core/support/message.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Returns messages about contradictory patient data or laterality, comparing the scan with every angiogram and the
/// angiograms with each other. The messages contain no duplicates and no patient identity.
Messages findMismatch(const Case& session);

/// One patient and the inputs of the case that show this patient.
struct CasePatient {
    StudyIdentity identity;   ///< name, number, birth date and sex, combined from all these inputs
    bool isScanPatient = false;
    std::vector<std::size_t> views;   ///< indices into Case::views
};

/// Returns the patients of the case's inputs, the scan's patient first; more than one only if the inputs contradict
/// each other. Inputs without patient data are skipped.
std::vector<CasePatient> patientsOf(const Case& session);

}   // namespace angiopose::core

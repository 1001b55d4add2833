#pragma once

#include "core/case/case.h"
#include "core/support/message.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Reports contradictions between the images of a case about patient or body side: the scan against every angiogram,
/// and the angiograms of the views against each other. Messages are unique and name no patient.
Messages findMismatch(const Case& session);

/// One patient and the inputs of the case that belong to them.
struct CasePatient {
    StudyIdentity identity;   ///< name, number, birth date and sex, combined from all these inputs
    bool isOfScan = false;
    std::vector<std::size_t> views;   ///< indices into Case::views
};

/// Returns the patients of the case's inputs, the scan's first; a single one unless the inputs contradict each other.
/// Skips inputs without patient data.
std::vector<CasePatient> patientsOf(const Case& session);

}   // namespace angiopose::core

#pragma once

#include "core/case/case.h"
#include "core/support/message.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// What speaks against the images of a case being of one patient and one side: the scan against every angiogram, and
/// the angiograms of views against each other. Names nobody; every sentence once.
Messages findMismatch(const Case& session);

/// Whom inputs of a case are of.
struct CasePatient {
    StudyIdentity identity;   ///< name, number, birth date and sex, put together from all these inputs
    bool isOfScan = false;
    std::vector<std::size_t> views;   ///< places in Case::views
};

/// Whom the inputs of a case are of, the scan's first: one where nothing speaks against it. Inputs that say nothing of
/// a patient are left out.
std::vector<CasePatient> patientsOf(const Case& session);

}   // namespace angiopose::core

#pragma once

#include "core/support/result.h"
#include "io/case/case_document.h"
#include "io/support/read_observer.h"

#include <string>
#include <vector>

namespace io {

/// Paths of a case file are relative to its folder.
void makePathsAbsolute(core::RegistrationCase& values, const std::string& casePath);

/// The case's own values win over the header's.
void fillFromHeader(core::CArm& cArm, const core::CArm& header);

/// The case with its inputs (absolute paths) read and checked against what it says: frame, camera size, branches,
/// hashes, start pose.
core::Result<core::RegistrationCase> loadInputs(CaseDocument document, const std::string& casePath,
                                                std::vector<std::string>& warnings, const ReadObserver& observe);

}   // namespace io

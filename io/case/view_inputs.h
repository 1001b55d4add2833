#pragma once

#include "io/case/case_document.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Reads what a view consists of: image, given centreline and subtraction; completes frame, geometry and pose. The
/// vessels are there already. Fails naming the file.
core::Status loadView(CaseDocument& document, const std::string& casePath, core::Messages& warnings);

/// Another view of the vessels of `first`, see core::viewOf. Where it cannot be read, that is a warning and the view
/// has no angiogram.
core::RegistrationCase loadOtherView(CaseDocument document, const core::RegistrationCase& first,
                                     const std::string& casePath, core::Messages& warnings);

/// Fills in what `cArm` lacks.
void fillFromHeader(core::CArm& cArm, const core::CArm& header);

/// Notes the hash of what was read; warns where the case expected something else.
core::Status checkHash(core::InputFile& file, core::Result<std::string> hash, core::Messages& warnings);

}   // namespace angiopose::io
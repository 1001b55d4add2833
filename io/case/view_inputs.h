#pragma once

#include "io/case/case_document.h"
#include "io/peak_frame.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Reads what a view of these vessels consists of: image, given centreline and subtraction; completes frame, geometry
/// and pose. Fails naming the file.
core::Status loadView(core::View& view, const ViewNotes& notes, const core::Vessels& vessels,
                      const std::string& casePath, core::Messages& warnings, PeakFrame peak);

/// Likewise of a view beside the first: where it cannot be read, that is a warning and the view has no angiogram.
void loadOtherView(core::View& view, const ViewNotes& notes, const core::Vessels& vessels, const std::string& casePath,
                   core::Messages& warnings, PeakFrame peak);

/// Fills in what `cArm` lacks.
void fillFromHeader(core::CArm& cArm, const core::CArm& header);

/// Notes the hash of what was read; warns where the case expected something else.
core::Status checkHash(core::InputFile& file, core::Result<std::string> hash, core::Messages& warnings);

}   // namespace angiopose::io
#pragma once

#include "io/case/case_document.h"
#include "io/peak_frame.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Reads the inputs of one view of the vessels: image, stored centerline and subtraction; sets frame, geometry and
/// pose. Fails and names the file if an input cannot be read.
core::Status loadView(core::View& view, const ViewNotes& notes, const core::Vessels& vessels,
                      const std::string& casePath, core::Messages& warnings, PeakFrameSearch peak);

/// Reads the inputs of an additional view; if they cannot be read, adds a warning and leaves the view without an
/// angiogram.
void loadOtherView(core::View& view, const ViewNotes& notes, const core::Vessels& vessels, const std::string& casePath,
                   core::Messages& warnings, PeakFrameSearch peak);

/// Fills in missing values of `cArm` from the header.
void fillFromHeader(core::CArm& cArm, const core::CArm& header);

/// Stores the hash of the file that was read; warns if the case stored a different one.
core::Status checkHash(core::InputFile& file, core::Result<std::string> hash, core::Messages& warnings);

}   // namespace angiopose::io

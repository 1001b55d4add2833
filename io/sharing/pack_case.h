#pragma once

#include "io/sharing/copied_inputs.h"

#include <string>

namespace angiopose::io {

/// Packs a case with its inputs and stored results into a ZIP archive that opens elsewhere (FORMATS §7):
/// `case.angiopose` and the inputs beside it. Without identity where that is wished: inputs as `deidentifyFile`, texts
/// as `clearTexts`, results sealed anew. Before the archive is written the packed case is opened and compared: views,
/// pixels, vessels and results must be there. Warnings name what to look at. Nothing is left behind when it fails or is
/// stopped.
core::Result<core::Messages> packCase(const core::Case& session, const std::string& archivePath,
                                      const CopyRequest& request, const ReadObserver& observe = {});

/// The same of a case file, with the warnings of opening it.
core::Result<core::Messages> packCaseFile(const std::string& casePath, const std::string& archivePath,
                                          const CopyRequest& request, const ReadObserver& observe = {});

}   // namespace angiopose::io

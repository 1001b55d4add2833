#pragma once

#include "io/sharing/copied_inputs.h"

#include <string>

namespace angiopose::io {

/// Packs a case with its inputs and stored results into a ZIP archive that opens elsewhere (FORMATS §7):
/// `case.angiopose` with the inputs next to it. De-identifies on request: inputs by `deidentifyFile`, texts by
/// `clearTexts`, results sealed again. Before writing the archive, opens the packed case and compares it: views,
/// pixels, vessels and results must be present. Warnings name what to review. Leaves nothing behind if it fails or is
/// stopped.
core::Result<core::Messages> packCase(const core::Case& session, const std::string& archivePath,
                                      const CopyRequest& request, const ReadObserver& observe = {});

/// Packs a case file in the same way, with the warnings from opening it.
core::Result<core::Messages> packCaseFile(const std::string& casePath, const std::string& archivePath,
                                          const CopyRequest& request, const ReadObserver& observe = {});

}   // namespace angiopose::io

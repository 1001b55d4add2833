#pragma once

#include "io/sharing/copied_inputs.h"

#include <string>

namespace angiopose::io {

/// Packs a case with its inputs and stored results into a ZIP archive that can be opened on other computers (FORMATS
/// §7): `case.angiopose` with the inputs next to it. De-identifies on request: inputs with `deidentifyFile`,
/// user-entered text with `removeTexts`; then updates the digests of the results. Before writing the archive, opens the
/// packed case and verifies that views, pixels, vessels and results are complete. Warnings name what needs review.
/// Leaves no file behind on failure or cancellation.
core::Result<core::Messages> packCase(const core::Case& session, const std::string& archivePath,
                                      const CopyOptions& request, const ReadObserver& observe = {});

/// Opens a case file and packs the case in the same way; the warnings include those from opening it.
core::Result<core::Messages> packCaseFile(const std::string& casePath, const std::string& archivePath,
                                          const CopyOptions& request, const ReadObserver& observe = {});

}   // namespace angiopose::io

#pragma once

#include "core/support/result.h"
#include "io/deidentify/deidentify_dicom.h"
#include "io/deidentify/output_folder.h"
#include "io/support/read_observer.h"

#include <string>

namespace angiopose::io {

/// Writes a de-identified DICOM image or object, PNG, JPEG or TIFF (FORMATS §7); warnings name what to review.
core::Result<core::Messages> deidentifyFile(const std::string& path, const std::string& output,
                                            const DeidentificationOptions& options, const Pseudonyms& pseudonyms);

/// De-identifies the DICOM images and objects of a folder and its subfolders into `output`, a new or empty folder, as
/// `series-1/00001.dcm` and so on; series are numbered in the order of their file names. Skips other files with a
/// warning. Leaves no file behind on failure or cancellation.
core::Result<core::Messages> deidentifyFolder(const std::string& path, const std::string& output,
                                              const DeidentificationOptions& options, const Pseudonyms& pseudonyms,
                                              const ReadObserver& observe = {});

}   // namespace angiopose::io

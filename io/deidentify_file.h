#pragma once

#include "core/support/result.h"
#include "io/deidentify/deidentify_dicom.h"
#include "io/deidentify/output_folder.h"
#include "io/support/read_observer.h"

#include <string>

namespace angiopose::io {

/// Writes a DICOM image or object, PNG, JPEG or TIFF without identity (FORMATS §7); warnings name what to look at.
core::Result<core::Messages> deidentifyFile(const std::string& path, const std::string& output,
                                            const Deidentification& requested, const Pseudonyms& pseudonyms);

/// Writes the DICOM images and objects of a folder and of those below it to `series-1/00001.dcm` and on in `output`, a
/// new or empty folder; series come in the order of their files' names. Other files are left out with a word. When it
/// fails or is stopped, nothing is left behind.
core::Result<core::Messages> deidentifyFolder(const std::string& path, const std::string& output,
                                              const Deidentification& requested, const Pseudonyms& pseudonyms,
                                              const ReadObserver& observe = {});

}   // namespace angiopose::io

#pragma once

#include "core/support/result.h"
#include "io/deidentify/deidentify_dicom.h"
#include "io/support/read_observer.h"

#include <string>
#include <vector>

namespace angiopose::io {

struct DeidentifiedFiles {
    std::size_t written = 0;
    core::Messages skipped;   ///< one message per skipped file, which states the reason
    core::Messages warnings;   ///< warnings about the written files, without duplicates
};

/// De-identifies files, folders and their subfolders into `output`, a new or empty folder: DICOM images and objects as
/// `series-1/00001.dcm`, PNG, JPEG and TIFF as `picture-1.png` and so on. Skips other files and lists them. If no file
/// can be written, or on cancellation, fails and leaves no file behind.
core::Result<DeidentifiedFiles> deidentifyFiles(const std::vector<std::string>& paths, const std::string& output,
                                                const DeidentificationOptions& options, const Pseudonyms& pseudonyms,
                                                const ReadObserver& observe = {});

}   // namespace angiopose::io

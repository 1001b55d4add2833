#pragma once

#include "core/support/result.h"
#include "io/deidentify/deidentify_dicom.h"
#include "io/support/read_observer.h"

#include <string>
#include <vector>

namespace angiopose::io {

struct DeidentifiedFiles {
    std::size_t written = 0;
    core::Messages refused;   ///< why, and about which file
    core::Messages warnings;   ///< of those that were written, each once
};

/// Writes files, and those of folders and below, without identity into `output`, a new or empty folder: DICOM images
/// and objects as `series-1/00001.dcm`, PNG, JPEG and TIFF as `picture-1.png`. What is neither is refused and told.
/// Fails, leaving nothing behind, where nothing could be written, or when it is stopped.
core::Result<DeidentifiedFiles> deidentifyFiles(const std::vector<std::string>& paths, const std::string& output,
                                                const Deidentification& requested, const Pseudonyms& pseudonyms,
                                                const ReadObserver& observe = {});

}   // namespace angiopose::io

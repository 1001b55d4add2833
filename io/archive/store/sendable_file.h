#pragma once

#include "core/support/result.h"

#include <cstdint>
#include <string>

namespace angiopose::io {

/// DICOM file that can be sent unmodified in its own transfer syntax.
struct SendableFile {
    std::string path;
    std::string sopClass;
    std::string sopInstance;
    std::string studyUid;
    std::string transferSyntax;
    std::uint64_t dataset = 0;   ///< offset of the data set
    std::uint64_t bytes = 0;   ///< total file size, bytes
};

/// Reads the header of a DICOM file; fails and names the file if it cannot be sent.
core::Result<SendableFile> readSendableFile(const std::string& path);

}   // namespace angiopose::io

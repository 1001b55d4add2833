#pragma once

#include "core/support/result.h"

#include <cstdint>
#include <string>

namespace angiopose::io {

/// A DICOM file as it can be sent: whole, in its own transfer syntax.
struct SendableFile {
    std::string path;
    std::string sopClass;
    std::string sopInstance;
    std::string studyUid;
    std::string transferSyntax;
    std::uint64_t dataset = 0;   ///< where its data set begins
    std::uint64_t bytes = 0;   ///< of the whole file
};

/// Fails, naming the file, on what is not one. Only its header is read.
core::Result<SendableFile> readSendableFile(const std::string& path);

}   // namespace angiopose::io

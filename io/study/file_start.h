#pragma once

#include "core/support/result.h"
#include "io/support/read_observer.h"

#include <cstddef>
#include <string>

namespace angiopose::io {

/// First bytes of a file. They are read rather than memory-mapped, because reading from a scratched disc fails, whereas
/// a mapping would crash the program.
struct FileStart {
    std::string bytes;
    std::size_t fileSize = 0;

    bool isComplete() const { return bytes.size() >= fileSize; }
};

/// Reads at most `size` bytes. Fails if the file is not readable, and on cancellation.
core::Result<FileStart> readFileStart(const std::string& path, std::size_t size, const ReadObserver& observe = {});

}   // namespace angiopose::io

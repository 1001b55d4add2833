#pragma once

#include "core/support/result.h"
#include "io/support/read_observer.h"

#include <cstddef>
#include <string>

namespace angiopose::io {

/// The first bytes of a file, read rather than mapped: on a scratched disc that fails, where a mapping would end the
/// program.
struct FileStart {
    std::string bytes;
    std::size_t fileSize = 0;

    bool isWhole() const { return bytes.size() >= fileSize; }
};

/// At most `size` bytes. Fails on what is no readable file, and when stopped.
core::Result<FileStart> readStart(const std::string& path, std::size_t size, const ReadObserver& observe = {});

}   // namespace angiopose::io

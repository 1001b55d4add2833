#pragma once

#include <string>

namespace angiopose::core {

/// A file that the case refers to.
struct InputFile {
    std::string path;   ///< absolute; empty when there is none
    std::string sha256;   ///< lower-case hex digest of the contents when the file was read; empty if unknown

    bool operator==(const InputFile&) const = default;
};

}   // namespace angiopose::core

#pragma once

#include <string>

namespace angiopose::core {

/// A file the case refers to.
struct InputFile {
    std::string path;   ///< absolute; empty when there is none
    std::string sha256;   ///< lower-case hex of the content when it was read; empty when not yet known

    bool operator==(const InputFile&) const = default;
};

}   // namespace angiopose::core

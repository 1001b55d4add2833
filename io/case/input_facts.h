#pragma once

#include <cstdint>
#include <string>

namespace angiopose::io {

/// By what an input is known again: a file, or a folder by the files in it.
struct InputFacts {
    std::string path;
    bool isThere = false;
    std::uint64_t size = 0;   ///< bytes, of all files
    std::int64_t modified = 0;   ///< of the newest, in the file system's own count
    std::string sha256;   ///< of a file's content; empty: not known

    bool operator==(const InputFacts&) const = default;
};

InputFacts factsOfInput(const std::string& path, const std::string& sha256 = {});

/// Whether the input is still that. Where its time alone is another, its content decides, if that is known.
bool isUnchanged(const InputFacts& known);

}   // namespace angiopose::io

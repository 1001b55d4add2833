#pragma once

#include <cstdint>
#include <string>

namespace angiopose::io {

/// Properties by which an unchanged input is recognized. The input is a file or a folder.
struct InputFingerprint {
    std::string path;
    bool isPresent = false;
    std::uint64_t size = 0;   ///< total size of all files, bytes
    std::int64_t modificationTime = 0;   ///< modification time of the newest file, in file-system ticks
    std::string sha256;   ///< content hash of a file; empty if unknown

    bool operator==(const InputFingerprint&) const = default;
};

InputFingerprint inputFingerprint(const std::string& path, const std::string& sha256 = {});

/// Returns whether the input is unchanged. If only the modification time differs, a known content hash decides.
bool isUnchanged(const InputFingerprint& known);

}   // namespace angiopose::io

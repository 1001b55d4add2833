#pragma once

#include "core/support/result.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Writes a large file in chunks so that either the old or the new file exists in full: writes a temporary file in the
/// same folder; `commit` flushes and renames it. Without a commit, no file is left behind.
class AtomicFile {
public:
    static core::Result<AtomicFile> create(const std::string& path);
    AtomicFile(AtomicFile&& other) noexcept;
    AtomicFile& operator=(AtomicFile&& other) noexcept;
    ~AtomicFile();

    core::Status write(std::string_view content);
    core::Status commit();

private:
    AtomicFile(std::string path, std::string target, std::string temporary, int file);

    std::string path_;   ///< path as the caller specified it, for messages
    std::string target_;
    std::string temporary_;
    int file_ = -1;
};

/// Writes a file so that either the old or the new file exists in full: writes a temporary file in the same folder,
/// flushes and renames it.
core::Status writeAtomically(const std::string& path, std::string_view content);

}   // namespace angiopose::io
